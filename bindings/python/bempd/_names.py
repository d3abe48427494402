"""The words that arguments take, for type checkers and editors."""

from __future__ import annotations

from typing import Literal, Union

Component = Literal["x", "y"]
Components = Literal["x", "y", "both"]
Plane = Literal["stress", "strain"]
Turn = Literal["counter-clockwise", "clockwise"]
FaceComponent = Literal["pressure", "shear"]
Face = Literal["left", "right"]
Until = Literal["values", "event", "separated"]
FieldName = Literal["position", "displacement", "stress", "damage", "traction", "bond_stretch", "element_stress", "stress_order"]
Quantity = Literal["outline", "lattice", "damage", "displacement", "displacement x", "displacement y", "stress xx", "stress yy",
                   "stress xy", "stress principal", "stress smallest principal", "stress shear", "stress von Mises", "x", "y", "xx",
                   "yy", "xy", "principal", "smallest principal", "shear", "von Mises"]
#: An edge by its number, from 1, or by its name, which must be that of one edge.
Edge = Union[int, str]
