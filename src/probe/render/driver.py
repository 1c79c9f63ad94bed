"""Is there a Vulkan driver? A missing one aborts the process that asks Filament, so ask first."""

from __future__ import annotations

import ctypes
import functools
import sys

from probe.errors import NoGraphicsDriver

_REMEDY = (
    "On Debian or Ubuntu without a GPU: apt-get install mesa-vulkan-drivers. "
    "With a GPU: install the vendor's driver with its Vulkan part."
)
_INSTANCE_CREATE_INFO = 1
_INCOMPATIBLE_DRIVER = -9


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


if __name__ == "__main__":
    try:
        require_driver()
    except NoGraphicsDriver as failure:
        sys.exit(str(failure))
