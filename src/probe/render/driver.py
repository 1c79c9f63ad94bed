"""Is what the engines need on this machine? Without it they abort their process, so ask first."""

from __future__ import annotations

import ctypes
import functools
import sys
from importlib.util import find_spec

from probe.errors import MissingExtra, NoGraphicsDriver

_REMEDY = (
    "On Debian or Ubuntu without a GPU: apt-get install mesa-vulkan-drivers. "
    "With a GPU: install the vendor's driver with its Vulkan part."
)
_INSTANCE_CREATE_INFO = 1
_INCOMPATIBLE_DRIVER = -9


_BLENDER_NEEDS = (
    *("EGL.so.1", "GL.so.1", "X11.so.6", "Xfixes.so.3"),
    *("Xi.so.6", "Xrender.so.1", "SM.so.6", "xkbcommon.so.0"),
)
_BLENDER_REMEDY = (
    "On Debian or Ubuntu: apt-get install libegl1 libgl1 libgl1-mesa-dri libx11-6 libxfixes3 "
    "libxi6 libxrender1 libsm6 libxkbcommon0."
)


class _InstanceCreateInfo(ctypes.Structure):
    """VkInstanceCreateInfo, Vulkan 1.0 specification, section 4.2."""

    _fields_ = (
        ("sType", ctypes.c_int32),
        ("pNext", ctypes.c_void_p),
        ("flags", ctypes.c_uint32),
        ("pApplicationInfo", ctypes.c_void_p),
        ("enabledLayerCount", ctypes.c_uint32),
        ("ppEnabledLayerNames", ctypes.c_void_p),
        ("enabledExtensionCount", ctypes.c_uint32),
        ("ppEnabledExtensionNames", ctypes.c_void_p),
    )


@functools.cache
def require_driver() -> None:
    """Return if a Vulkan instance with at least one device can be made.

    Raises:
        NoGraphicsDriver: No loader, no driver, or a driver without a device.
    """
    try:
        vulkan = ctypes.CDLL("libvulkan.so.1")
    except OSError as error:
        raise NoGraphicsDriver(
            f"No Vulkan loader (libvulkan.so.1) on this machine. {_REMEDY}"
        ) from error
    instance = ctypes.c_void_p()
    info = _InstanceCreateInfo(sType=_INSTANCE_CREATE_INFO)
    status = vulkan.vkCreateInstance(ctypes.byref(info), None, ctypes.byref(instance))
    if status == _INCOMPATIBLE_DRIVER:
        raise NoGraphicsDriver(f"A Vulkan loader is here but no driver. {_REMEDY}")
    if status != 0:
        raise NoGraphicsDriver(f"vkCreateInstance failed with code {status}. {_REMEDY}")
    count = ctypes.c_uint32(0)
    vulkan.vkEnumeratePhysicalDevices(instance, ctypes.byref(count), None)
    vulkan.vkDestroyInstance(instance, None)
    if count.value == 0:
        raise NoGraphicsDriver(f"The Vulkan driver offers no device. {_REMEDY}")


@functools.cache
def require_blender() -> None:
    """Return if Blender is installed with the system's libraries it needs.

    Raises:
        MissingExtra: The Python package isn't there.
        NoGraphicsDriver: A library of the system's isn't.
    """
    if find_spec("bpy") is None:
        raise MissingExtra("Drawing with Blender (Python 3.11)", "blender")
    for name in _BLENDER_NEEDS:
        try:
            ctypes.CDLL(f"lib{name}")
        except OSError as error:
            raise NoGraphicsDriver(f"Blender needs lib{name}. {_BLENDER_REMEDY}") from error


if __name__ == "__main__":
    try:
        require_driver()
    except NoGraphicsDriver as failure:
        sys.exit(str(failure))
