"""The one live picture of the course: views, controls, handles, a motion and challenges, alive without a kernel.

All numbers are SymPy expressions, compiled to JavaScript; the page asks for nothing. ``parts`` says what a stage
is made of, ``script`` compiles formulas, ``page`` puts the page together. Of the scripts in it ``geometry.js`` is
pure (where things stand, and what follows from a drag), ``drawing.js`` draws, and ``stage.js`` listens.
"""

from .page import stage
from .parts import (
    ALWAYS,
    Body,
    Challenge,
    Choice,
    Control,
    Handle,
    Item,
    Level,
    Line,
    Motion,
    Plane,
    Slider,
    Space,
    Words,
    before,
)
from .script import javascript, largest, least, magnitude
