"""Downloads from a server of our own that breaks off, lies, and changes its mind."""

from __future__ import annotations

import hashlib
import http.server
import re
import resource
import signal
import threading
import zipfile
from collections.abc import Iterator

import numpy as np
import pytest

from probe.assets.fetching.download import download
from probe.assets.fetching.sites import place_of, places
from probe.assets.fetching.unpack import unpack
from probe.errors import BadData, DownloadFailed, OutputFailed, UnknownName

CONTENT = np.random.default_rng(0).bytes(3_000_000)
HASH = hashlib.sha256(CONTENT).hexdigest()


class Server(http.server.ThreadingHTTPServer):
    """Serves one file; may break off after some bytes, for a number of answers."""

    content = CONTENT
    tag = '"one"'
    ranges = True
    breaks: list[int] = []
    asked: list[str] = []

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_address[1]}/file.zip"


class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self) -> None:
        assert isinstance(self.server, Server)
        self.server.asked.append(self.headers.get("Range", ""))
        if self.path != "/file.zip":
            self.send_error(404)
            return
        start = 0
        match = re.fullmatch(r"bytes=(\d+)-", self.headers.get("Range", ""))
        if match and self.server.ranges and self.headers.get("If-Range") == self.server.tag:
            start = int(match.group(1))
        rest = self.server.content[start:]
        self.send_response(206 if start else 200)
        self.send_header("Content-Length", str(len(rest)))
        self.send_header("ETag", self.server.tag)
        self.end_headers()
        end = self.server.breaks.pop(0) if self.server.breaks else len(rest)
        self.wfile.write(rest[:end])

    def log_message(self, format: str, *args: object) -> None:
        pass


@pytest.fixture
def server() -> Iterator[Server]:
    made = Server(("127.0.0.1", 0), Handler)
    made.breaks, made.asked = [], []
    thread = threading.Thread(target=made.serve_forever, daemon=True)
    thread.start()
    yield made
    made.shutdown()
    made.server_close()
    thread.join()


def _download(server: Server, path, sha256=HASH, url=None) -> str:
    return download(url or server.url, path, sha256, lambda there, total: None, pause=0.01)


def test_a_file_comes_whole(server, tmp_path):
    path = tmp_path / "deep" / "file.zip"
    assert _download(server, path) == HASH
    assert path.read_bytes() == CONTENT
    assert [entry.name for entry in path.parent.iterdir()] == ["file.zip"]
    assert _download(server, path) == HASH
    assert len(server.asked) == 1


def test_a_broken_connection_is_resumed(server, tmp_path):
    server.breaks = [1_000_000, 500_000]
    assert _download(server, tmp_path / "file.zip") == HASH
    assert server.asked == ["", "bytes=1000000-", "bytes=1500000-"]


def test_what_was_interrupted_goes_on_later(server, tmp_path):
    path = tmp_path / "file.zip"
    server.breaks = [100_000] * 4
    with pytest.raises(DownloadFailed, match="Run it again"):
        _download(server, path)
    assert not path.exists()
    assert (tmp_path / "file.zip.part").stat().st_size == 400_000
    server.asked.clear()
    assert _download(server, path) == HASH
    assert server.asked == ["bytes=400000-"]


def test_a_file_that_changed_meanwhile_is_begun_anew(server, tmp_path):
    server.breaks = [100_000] * 4
    with pytest.raises(DownloadFailed):
        _download(server, tmp_path / "file.zip")
    server.content, server.tag = CONTENT[::-1], '"two"'
    expected = hashlib.sha256(CONTENT[::-1]).hexdigest()
    assert _download(server, tmp_path / "file.zip", expected) == expected


def test_a_server_without_ranges_works_too(server, tmp_path):
    server.ranges = False
    server.breaks = [1_000_000]
    assert _download(server, tmp_path / "file.zip") == HASH


def test_a_wrong_checksum_leaves_nothing(server, tmp_path):
    with pytest.raises(DownloadFailed, match=HASH):
        _download(server, tmp_path / "file.zip", "0" * 64)
    assert list(tmp_path.iterdir()) == []


def test_a_wrong_file_that_is_there_is_replaced(server, tmp_path):
    (tmp_path / "file.zip").write_bytes(b"old")
    assert _download(server, tmp_path / "file.zip") == HASH


def test_what_isnt_there_is_told_at_once(server, tmp_path):
    with pytest.raises(DownloadFailed, match="404"):
        _download(server, tmp_path / "x", url=server.url.replace("file", "none"))
    assert len(server.asked) == 1
    with pytest.raises(DownloadFailed, match="refused"):
        _download(server, tmp_path / "x", url="http://127.0.0.1:9/x")
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_leaves_nothing(server, tmp_path):
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    ignored = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (1_000_000, before[1]))
    try:
        with pytest.raises(OutputFailed, match="too large"):
            _download(server, tmp_path / "file.zip")
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
        signal.signal(signal.SIGXFSZ, ignored)
    assert list(tmp_path.iterdir()) == []


def _zip(path, **files: str):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for name, text in files.items():
            file.writestr(name, text)
    return path


def test_a_zip_is_unpacked_and_replaces_what_was_there(tmp_path):
    folder = tmp_path / "out" / "set"
    folder.mkdir(parents=True)
    (folder / "old").touch()
    unpack(_zip(tmp_path / "x.zip", **{"a/b.txt": "hello"}), folder)
    assert [str(p.relative_to(folder)) for p in sorted(folder.rglob("*"))] == ["a", "a/b.txt"]
    assert [entry.name for entry in folder.parent.iterdir()] == ["set"]


@pytest.mark.parametrize("name", ["../x", "a/../../x", "/x", "C:/x", "..\\x"])
def test_a_zip_that_leads_outside_is_refused(tmp_path, name):
    archive = _zip(tmp_path / "x.zip", **{"fine": "", name: "evil"})
    with pytest.raises(BadData, match="outside its folder"):
        unpack(archive, tmp_path / "out" / "set")
    assert not (tmp_path / "out").exists()


def test_links_and_damage_are_refused(tmp_path):
    link = zipfile.ZipInfo("link")
    link.external_attr = 0o120777 << 16
    with zipfile.ZipFile(tmp_path / "x.zip", "w") as file:
        file.writestr(link, "/etc")
    with pytest.raises(BadData, match="holds a link"):
        unpack(tmp_path / "x.zip", tmp_path / "set")
    content = _zip(tmp_path / "y.zip", a="hello " * 1000).read_bytes()
    (tmp_path / "y.zip").write_bytes(content[:40] + b"\0\0\0\0" + content[44:])
    with pytest.raises(BadData, match="no whole ZIP"):
        unpack(tmp_path / "y.zip", tmp_path / "set")
    (tmp_path / "z.zip").write_bytes(b"<html>")
    with pytest.raises(BadData, match="no whole ZIP"):
        unpack(tmp_path / "z.zip", tmp_path / "set")
    assert not (tmp_path / "set").exists()


def test_names_lead_to_addresses():
    place, item = place_of("bop/ycbv", places())
    assert place.url_of(item).endswith("/ycbv/resolve/main/ycbv_models.zip")
    assert place.file_of(item) == "ycbv_models.zip"
    with pytest.raises(UnknownName, match="gso/"):
        place_of("elsewhere/x", places())
    for name in ("gso", "gso/", "gso/../x", "gso/a b", "gso/-x"):
        with pytest.raises(BadData, match="gso/Nintendo"):
            place_of(name, places())
