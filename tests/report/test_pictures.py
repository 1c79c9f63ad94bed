"""Depth and labels as images."""

import numpy as np
from PIL import Image

from probe.report.pictures import depth_image, label_colour, label_image


def test_depth_is_in_tenths_of_a_millimetre(tmp_path):
    depth_image(np.array([[1.2, 0.12345], [np.nan, 99.0]])).save(tmp_path / "depth.png")
    read = np.asarray(Image.open(tmp_path / "depth.png"))
    assert read.tolist() == [[12000, 1234], [0, 65535]]


def test_labels_keep_their_values_and_show_colours(tmp_path):
    labels = np.array([[0, 1], [2, 200]])
    label_image(labels).save(tmp_path / "labels.png")
    image = Image.open(tmp_path / "labels.png")
    assert np.asarray(image).tolist() == labels.tolist()
    assert image.convert("RGB").getpixel((1, 1)) == label_colour(200)
    assert len({label_colour(n) for n in range(40)}) == 40
