"""An independent look at a scene: one Embree ray through the middle of every pixel."""

from __future__ import annotations

import numpy as np
import scipy.ndimage
import trimesh
from trimesh.ray.ray_pyembree import RayMeshIntersector


def cast(objects, meshes, camera, table_extent):
    """Labels, int (h, w), and planar depth in metres, float (h, w), of placed objects on a table.

    Built from vertices and faces alone; the table is a quad at z = 0.
    """
    half = np.array([*table_extent, 0]) / 2
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * half
    parts = [trimesh.Trimesh(corners, [[0, 1, 2], [0, 2, 3]], process=False)]
    owner = [np.zeros(2, int)]
    for item in objects:
        mesh = meshes[item.object_id]
        w, x, y, z = item.pose.wxyz
        transform = trimesh.transformations.quaternion_matrix([w, x, y, z])
        transform[:3, 3] = item.pose.position
        part = trimesh.Trimesh(mesh.vertices.astype(float), mesh.faces, process=False)
        parts.append(part.apply_transform(transform))
        owner.append(np.full(len(mesh.faces), item.instance))
    whole = trimesh.util.concatenate(parts)
    # Embree's default precision leaves holes between triangles at this scale.
    caster = RayMeshIntersector(whole, scale_to_box=True)
    origins, directions, forward = _rays(camera)
    hit = caster.intersects_first(origins, directions)
    labels = np.where(hit >= 0, np.concatenate(owner)[hit], 0)
    depth = _planar_depth(whole, hit, origins, directions, forward)
    shape = (camera.height_px, camera.width_px)
    return labels.reshape(shape), depth.reshape(shape)


def _rays(camera):
    v, u = np.mgrid[0 : camera.height_px, 0 : camera.width_px] + 0.5
    focal = camera.height_px / 2 / np.tan(np.radians(camera.fov_y_deg) / 2)
    local = np.stack(
        [(u - camera.width_px / 2) / focal, (v - camera.height_px / 2) / focal, np.ones_like(u)],
        axis=-1,
    ).reshape(-1, 3)
    w, x, y, z = camera.world_from_camera.wxyz
    rotation = trimesh.transformations.quaternion_matrix([w, x, y, z])[:3, :3]
    directions = local @ rotation.T
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    origins = np.tile(np.asarray(camera.world_from_camera.position), (len(local), 1))
    return origins, directions, rotation[:, 2]


def _planar_depth(mesh, hit, origins, directions, forward):
    """Distance along the optical axis to the plane of the triangle that each ray hits first."""
    normals = mesh.face_normals[hit]
    points = mesh.triangles[hit][:, 0]
    along = np.einsum("ij,ij->i", normals, points - origins)
    slope = np.einsum("ij,ij->i", normals, directions)
    distance = along / np.where(np.abs(slope) < 1e-9, np.nan, slope)
    return np.where(hit >= 0, distance * (directions @ forward), np.nan)


def away_from_edges(depth, step=0.005):
    """Pixels all of whose neighbours are hit at nearly the same depth, bool (h, w)."""
    low = scipy.ndimage.minimum_filter(np.nan_to_num(depth, nan=-1e9), 3)
    high = scipy.ndimage.maximum_filter(np.nan_to_num(depth, nan=1e9), 3)
    return high - low < step
