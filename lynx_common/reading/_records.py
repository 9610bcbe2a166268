"""Records of a robot's parameters."""

from collections.abc import Iterator
from dataclasses import fields
from typing import Any

import numpy as np

from ..errors import GeometryError


class Record:
    """Base of the frozen records of a robot's parameters, which are checked once, when they are made.

    ``values`` holds them as floats, in the order in which the record unpacks; it is an array to NumPy.
    """

    values: tuple[float, ...]

    def __new__(cls, /, *_: object, **parameters: object) -> "Record":
        known = [field.name for field in fields(cls)]  # type: ignore[arg-type]  # of the dataclasses made of it
        for name in parameters.keys() - known:
            raise GeometryError(name, parameters[name], f"there are {', '.join(known)}")
        return super().__new__(cls)

    def __iter__(self) -> Iterator[float]:
        return iter(self.values)

    def __array__(self, dtype: type | None = None, copy: bool | None = None) -> np.ndarray:
        return np.array(self.values, dtype=dtype)


def length(name: str, value: Any, unit: str, zero: bool = False) -> float:
    """A length of a robot, longer than zero unless it may be ``zero``; GeometryError otherwise.

    >>> length("L_1", sp.Integer(2) / 10, "metres")
    Traceback (most recent call last):
    lynx_common.errors.GeometryError: Geometry: L_1 is 1/5; a length is a real number of metres.
    """
    if not isinstance(value, int | float | np.number) or isinstance(value, bool | np.complexfloating):
        raise GeometryError(name, value, f"a length is a real number of {unit}")
    if not (np.isfinite(value) and (value > 0 or (zero and value == 0))):
        raise GeometryError(
            name, value, f"a length is finite and {'not negative' if zero else 'longer than zero'}"
        )
    return float(value)
