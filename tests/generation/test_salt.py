"""A private suite's salt: secret, shared by all who build, fixed by a commitment."""

from __future__ import annotations

import hashlib
import json
import stat
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from importlib.resources import files
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis.strategies import integers

from probe.checksum import with_sum, without_sum
from probe.errors import BadData
from probe.generation.attempt import Attempt
from probe.generation.build_folder import BuildFolder, BuildSettings, TaskSlot
from probe.generation.salt import PRIVATE_FROM, Salt
from probe.generation.salt_file import SALT, read_salt, salt_of
from probe.scene.seeds import generator
from probe.tasks.suite import part
from probe.tasks.suite_file import packaged_suite, read_suite, write_suite

ONE, OTHER = Salt(bytes(range(32))), Salt(bytes(range(1, 33)))


def making(salt: Salt | None) -> BuildSettings:
    return BuildSettings(
        pool="procedural", unchecked=False, commitment=salt.commitment if salt else None
    )


def begun(folder: Path) -> Salt:
    """The salt of a private suite that was begun in a folder."""
    salt = salt_of(BuildFolder(folder), public=False)
    assert salt
    BuildFolder(folder).claim(making(salt))
    return salt


def test_the_commitment_can_be_checked_by_hand():
    secret = bytes(range(32))
    assert ONE.commitment == hashlib.sha256(b"PROBE suite salt, version 1\0" + secret).hexdigest()


def test_a_salt_of_another_length_is_none():
    with pytest.raises(ValueError, match="32 bytes, not 16"):
        Salt(bytes(16))


def test_it_isnt_shown():
    assert ONE.secret.hex() not in repr(ONE) and "\\x01" not in repr(ONE)
    assert "secret" not in repr(Attempt(TaskSlot("find", 0), 0, ONE))


@given(value=integers(0, 2**40 - 1), bit=integers(0, 127))
def test_what_is_sealed_is_opened_by_the_salt_alone(value, bit):
    sealed = ONE.seal(value, "find")
    assert PRIVATE_FROM <= sealed < 2**128 and ONE.unseal(sealed, "find") == value
    assert OTHER.unseal(sealed, "find") is None and ONE.unseal(sealed, "count") is None
    assert ONE.unseal(sealed ^ 1 << bit, "find") is None


@pytest.mark.parametrize("value", [-1, 2**40])
def test_what_is_too_wide_isnt_sealed(value):
    with pytest.raises(ValueError, match="40 bits"):
        ONE.seal(value, "find")
    assert ONE.unseal(value, "find") is None


def test_no_two_are_drawn_alike_and_only_the_owner_can_read_one(tmp_path):
    first, second = begun(tmp_path / "a"), begun(tmp_path / "b")
    assert first != second
    assert stat.S_IMODE((tmp_path / "a" / SALT).stat().st_mode) == 0o600
    assert stat.S_IMODE((tmp_path / "a").stat().st_mode) == 0o700
    assert [path.name for path in (tmp_path / "a").iterdir() if path.name.startswith(".")] == []


def test_who_comes_back_has_the_same_and_so_has_everyone_who_begins_at_once(tmp_path):
    with ThreadPoolExecutor(8) as pool:
        found = set(pool.map(lambda _: salt_of(BuildFolder(tmp_path), public=False), range(16)))
    assert len(found) == 1
    assert {begun(tmp_path)} == {begun(tmp_path)} == found


def test_a_carried_salt_begins_the_same_suite_elsewhere(tmp_path):
    here = begun(tmp_path / "here")
    there = tmp_path / "there" / SALT
    there.parent.mkdir()
    there.write_bytes((tmp_path / "here" / SALT).read_bytes())
    assert begun(tmp_path / "there") == here


def test_a_folder_whose_salt_is_lost_or_another_is_refused(tmp_path):
    begun(tmp_path)
    (tmp_path / SALT).write_text(json.dumps({"version": 1, "salt": "ab" * 32}))
    with pytest.raises(BadData, match=r"salt\.json: isn't the salt .*Copy salt\.json"):
        salt_of(BuildFolder(tmp_path), public=False)
    (tmp_path / SALT).unlink()
    with pytest.raises(BadData, match=r"salt\.json: No such file .*Copy salt\.json"):
        salt_of(BuildFolder(tmp_path), public=False)


def test_public_and_private_suites_dont_mix(tmp_path):
    begun(tmp_path / "private")
    with pytest.raises(BadData, match="private suite was begun here.*--public"):
        salt_of(BuildFolder(tmp_path / "private"), public=True)
    # As older folders have it.
    public = tmp_path / "public" / "making.json"
    public.parent.mkdir()
    public.write_text('{"pool": "procedural", "unchecked": false}')
    with pytest.raises(BadData, match="public suite was begun here.*--public"):
        salt_of(BuildFolder(tmp_path / "public"), public=False)
    assert salt_of(BuildFolder(tmp_path / "public"), public=True) is None
    BuildFolder(tmp_path / "public").claim(making(None))


@pytest.mark.parametrize("text", ["", "{}", '{"version":1,"salt":"00"}', '{"version":2}'])
def test_a_broken_salt_is_named(tmp_path, text):
    (tmp_path / SALT).write_text(text)
    with pytest.raises(BadData, match=r"salt\.json: .*Fetch it"):
        read_salt(tmp_path / SALT, "Fetch it")


def test_a_suite_keeps_its_commitment(tmp_path):
    suite = replace(packaged_suite("demo"), commitment=ONE.commitment)
    write_suite(tmp_path / "some.json", part(suite, suite.tasks[0]))
    assert read_suite(tmp_path / "some.json").commitment == ONE.commitment


def test_what_isnt_a_commitment_is_refused(tmp_path):
    path = tmp_path / "some.json"
    suite = packaged_suite("demo")
    write_suite(path, part(replace(suite, commitment=ONE.commitment), suite.tasks[0]))
    changed = without_sum(path.read_bytes()).replace(ONE.commitment.encode(), b"trust me")
    path.write_bytes(with_sum(changed))
    with pytest.raises(BadData, match=r"some\.json: commitment"):
        read_suite(path)


@pytest.mark.parametrize("name", ["v1", "v1-scans", "v1-unfiltered"])
def test_public_suites_are_written_as_they_were(tmp_path, name):
    write_suite(tmp_path / "again.json", packaged_suite(name))
    frozen = (files("probe.tasks") / f"data/{name}.json").read_bytes()
    assert (tmp_path / "again.json").read_bytes() == with_sum(frozen)


def test_seeds_of_128_bits_come_back_and_decide_luck(tmp_path):
    task = packaged_suite("demo").tasks[0]
    seeds = [Attempt(TaskSlot("beneath", 0), number, ONE).bears for number in range(3)]
    assert all(PRIVATE_FROM <= seed < 2**128 for seed in seeds)
    seeded = replace(task, seed=seeds[0], scene=replace(task.scene, seed=seeds[0]))
    suite = replace(packaged_suite("demo"), tasks=(seeded,))
    write_suite(tmp_path / "some.json", suite)
    assert read_suite(tmp_path / "some.json").tasks == (seeded,)
    # Not the lower bits alone.
    near = [seeds[0], seeds[0] ^ (1 << 100), seeds[0] ^ 1]
    assert len({float(generator(seed, "luck").random()) for seed in (*seeds, *near)}) == 5
