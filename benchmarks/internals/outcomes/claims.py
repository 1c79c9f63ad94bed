"""What a tool's reply claims of things, read back from its text and held against the truth."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field

import numpy as np

from probe.perception.oracle import NOTICED_PX
from probe.scene.scene import Scene
from probe.tasks.grading import whereabouts
from probe.types import Array

_NOW = re.compile(r"(?<!turned or tipped, )now at \[(\d+), (\d+)\]")
_WAY = r"(?:about|at least) \d+ cm(?: (?:down|up) in height)?"
_MOVED = re.compile(rf"(?:by {_WAY}(?: and {_WAY})?, to|turned or tipped, now at) \[(\d+), (\d+)\]")
_SHOWN = re.compile(r"from \[(\d+), (\d+)\] to \[(\d+), (\d+)\]")
"""Of what had shown in part: where it was, and where it shows now."""
_TWINS = re.compile(r"which is which can't be told: (.*?)\.(?= [A-Z]|$)")
_PLACE = re.compile(r"\[(\d+), (\d+)\]")
_TURNED = re.compile(
    r"turned or tipped, (?:now )?at \[(\d+), (\d+)\]|\[(\d+), (\d+)\], turned or tipped"
)
_WENT = re.compile(
    r"by (about|at least) (\d+) cm(?: and about \d+ cm (?:down|up) in height)?, to \[(\d+), (\d+)\]"
)
_PUSHED = re.compile(r"moved about (\d+) cm that way, to \[(\d+), (\d+)\]")
_LEFT = re.compile(r"that was at \[(\d+), (\d+)\]")
_BASKET = re.compile(r"Also in the basket now: (.*?)\.(?: [A-Z]|$)")
_FAR = 0.03
_TURN, _ROLLS = np.radians(10), np.radians(30)
_SLACK, _SLACK_SHARE = 0.02, 0.25
_UNFOUND = re.compile(r"(?:Beside the basket[^:]*|Not found again): .*?(?=\. [A-Z]|$)")
"""What is told without a claim that the camera shows it no longer."""
_UNSEEN = ("shows neither", "shows no longer")


@dataclass(frozen=True, eq=False)
class Table:
    """How things stood at one time.

    Attributes:
        scene: Where everything is.
        labels: Instances in the fixed camera's picture, int, shape (h, w).
        in_basket: Visible pixels in the basket's picture, by instance.
        names: By instance.
    """

    scene: Scene
    labels: Array
    in_basket: Mapping[int, int]
    names: Mapping[int, str]

    def shows(self, instance: int) -> bool:
        """Whether a person would notice it on the table."""
        return int(np.count_nonzero(self.labels == instance)) >= NOTICED_PX

    def where(self, instance: int) -> str:
        return whereabouts(self.scene[instance].pose, self.scene.setup)

    def at(self, u: str, v: str) -> int:
        return int(self.labels[int(v), int(u)])


@dataclass(frozen=True)
class Verdict:
    """How one reply fares; lists hold names of things."""

    seed: int
    pool: str
    dense: bool
    tool: str
    text: str
    target: str
    done: bool
    false_done: bool
    in_basket: int
    basket_unsaid: list[str] = field(default_factory=list[str])
    moved: int = 0
    unmentioned: list[str] = field(default_factory=list[str])
    called_unseen: int = 0
    wrongly_unseen: list[str] = field(default_factory=list[str])
    placed: int = 0
    mixed_up: list[str] = field(default_factory=list[str])
    turned: int = 0
    wrongly_turned: list[str] = field(default_factory=list[str])
    ways: int = 0
    misjudged: list[str] = field(default_factory=list[str])

    def line(self) -> dict[str, object]:
        return asdict(self)


def judge(
    seed: int, pool: str, dense: bool, tool: str, text: str, target: int, old: Table, new: Table
) -> Verdict:
    """Hold a reply against what has really happened."""
    done = text.startswith("Done") and tool == "grasp"
    seen = [o.instance for o in old.scene.objects if old.shows(o.instance)]
    others = [number for number in seen if number != target and old.where(number) == "table"]
    fell_in = [number for number in others if new.where(number) == "basket"]
    listed = _BASKET.search(text)
    told = listed[1].split("; ") if listed else []
    said = [words.removesuffix(", not seen before") for words in told]
    unsaid = [old.names[n] for n in fell_in if old.names[n] not in said and not _unnamed(said)]
    inside = new.where(target) == "basket"
    if inside and not done and "lies in the basket" not in text:
        unsaid.append(old.names[target])
    changed = [n for n in others if n not in fell_in and (_far(old, new, n) or not new.shows(n))]
    now = [new.at(*place) for place in _MOVED.findall(text)]
    parts = _parts(text, old, new)
    left = [old.at(*place) for place in _LEFT.findall(text)]
    silent = [old.names[n] for n in changed if n not in {*now, *left, *(it for it, _ in parts)}]
    claimed = [old.at(*place) for place in _LEFT.findall(_UNFOUND.sub("", text))]
    unseen = claimed + ([target] if any(words in text for words in _UNSEEN) else [])
    wrong = [old.names[n] for n in unseen if new.shows(n) or new.in_basket.get(n, 0) >= NOTICED_PX]
    places = _NOW.findall(text)
    mixed = [old.names[target] for place in places if new.at(*place) != target]
    mixed += [old.names.get(n, "the table") for n in now if n not in others]
    mixed += [old.names.get(one, "the table") for one, other in parts if one != other]
    turned = [new.at(*filter(None, places)) for places in _TURNED.findall(text)]
    still = [old.names.get(n, "the table") for n in turned if not _has_turned(old, new, n)]
    return Verdict(
        seed, pool, dense, tool, text, old.names[target], done, done and not inside,
        len(fell_in) + inside, unsaid, len(changed), silent, len(unseen), wrong,
        len(places) + len(now) + len(parts), mixed, len(turned), still, *_ways(old, new, text),
    )  # fmt: skip


def _parts(text: str, old: Table, new: Table) -> list[tuple[int, int]]:
    """What lay where something is said to have been, and what lies where it is said to be.

    Of several things of one name that can't be told apart, in order of their numbers.
    """
    told = _TWINS.search(text)
    pairs = [(old.at(*it[:2]), new.at(*it[2:])) for it in _SHOWN.findall(_TWINS.sub("", text))]
    for group in told[1].split("; ") if told else ():
        was, now = (_PLACE.findall(some) for some in group.split(" to "))
        pairs += zip(
            sorted(old.at(*place) for place in was),
            sorted(new.at(*place) for place in now),
            strict=True,
        )
    return pairs


def _ways(old: Table, new: Table, text: str) -> tuple[int, list[str]]:
    """How many distances along the table are told, and those that are wrong.

    Of what rolled or fell over, the middle of what shows goes another way than the thing: left out.
    """
    told, wrong = 0, list[str]()
    pushed = [("about", cm, *place) for cm, *place in _PUSHED.findall(text)]
    for bound, cm, *place in [*_WENT.findall(text), *pushed]:
        instance, said = new.at(*place), float(cm) / 100
        if not instance or _turn(old, new, instance) > _ROLLS:
            continue
        one, other = (it.scene[instance].pose.position[:2] for it in (old, new))
        true = float(np.linalg.norm(np.subtract(other, one)))
        slack = _SLACK + _SLACK_SHARE * true
        told += 1
        # Of a push the text tells how far it went that way, and not aside.
        exact = bound == "about" and (bound, cm, *place) not in pushed
        if said - true > slack or (exact and true - said > slack):
            wrong.append(f"{old.names[instance]}: {bound} {cm} cm, and went {100 * true:.1f}")
    return told, wrong


def _unnamed(said: list[str]) -> bool:
    return any(words.startswith("part of something") for words in said)


def _far(old: Table, new: Table, instance: int) -> bool:
    way = np.subtract(new.scene[instance].pose.position, old.scene[instance].pose.position)
    return float(np.linalg.norm(way)) > _FAR


def _has_turned(old: Table, new: Table, instance: int) -> bool:
    """About any axis; of what is round, a turn doesn't show."""
    return instance != 0 and _turn(old, new, instance) > _TURN


def _turn(old: Table, new: Table, instance: int) -> float:
    """By how much a thing has turned, radians."""
    one, other = (np.array(it.scene[instance].pose.wxyz) for it in (old, new))
    return float(2 * np.arccos(min(1.0, abs(one @ other))))
