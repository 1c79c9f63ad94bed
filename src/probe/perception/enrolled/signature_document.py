"""A Signature as JSON: of its colours only the bins that hold something."""

from __future__ import annotations

from typing import Annotated

import numpy as np
import pydantic

from probe.perception.enrolled.colours import SHAPE
from probe.perception.enrolled.signature import Signature

_BINS = int(np.prod(SHAPE))
_LEAST_SHARE = 2e-4

_Share = Annotated[float, pydantic.Field(gt=0, le=1)]
_Extent = Annotated[float, pydantic.Field(ge=0, le=3)]


class SignatureDocument(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    """One signature; lengths in metres."""

    bins: tuple[Annotated[int, pydantic.Field(ge=0, lt=_BINS)], ...] = pydantic.Field(min_length=1)
    shares: tuple[_Share, ...]
    area: float = pydantic.Field(gt=0, le=9)
    length: _Extent
    width: _Extent
    height: _Extent
    outline: str = pydantic.Field(max_length=40)

    @pydantic.model_validator(mode="after")
    def _a_share_for_each_bin(self) -> SignatureDocument:
        if len(self.bins) != len(self.shares) or len(set(self.bins)) != len(self.bins):
            raise ValueError("bins and shares don't belong together")
        return self

    @staticmethod
    def of(signature: Signature) -> SignatureDocument:
        """The document of a signature."""
        colours = signature.colours.ravel()
        (bins,) = np.nonzero(colours >= _LEAST_SHARE)
        return SignatureDocument(
            bins=tuple(bins.tolist()),
            shares=tuple(round(float(share), 5) for share in colours[bins]),
            area=round(signature.area, 7),
            length=round(signature.length, 5),
            width=round(signature.width, 5),
            height=round(signature.height, 5),
            outline=signature.outline,
        )

    def signature(self) -> Signature:
        """The signature it describes; its colours add up to 1 again."""
        colours = np.zeros(_BINS)
        colours[list(self.bins)] = self.shares
        return Signature(
            (colours / colours.sum()).reshape(SHAPE),
            self.area,
            self.length,
            self.width,
            self.height,
            self.outline,
        )
