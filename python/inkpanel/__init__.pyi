import os
from collections.abc import Iterable, Sequence
from typing import Any, Union, final, overload

import numpy as np
from numpy.typing import NDArray

__version__: str

_Pixels = NDArray[np.uint8]
_Photo = Union[str, os.PathLike[str], bytes, _Pixels]
_Json = dict[str, Any]

class Error(ValueError):
    code: str
    file: str | None

@final
class Page:
    @property
    def width(self) -> int: ...
    @property
    def height(self) -> int: ...
    @property
    def dpi(self) -> int: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def plan(self) -> _Json: ...
    @property
    def image(self) -> _Pixels: ...
    def png(self) -> bytes: ...
    def jpeg(self, quality: int = 90) -> bytes: ...
    def pdf(self, *, title: str = "", language: str = "en") -> bytes: ...

def stylize(array: _Pixels, style: str | _Json, *, seed: int | None = None) -> _Pixels: ...
def book(
    photos: _Photo | Iterable[_Photo],
    output: str | os.PathLike[str] | None = None,
    *,
    title: str | None = None,
    language: str = "en",
    styles: str = "one",
    pages: int | None = None,
    style: str | _Json | None = None,
    seed: int = 1,
    page_size: str | tuple[int, int] | None = None,
    width: int | None = None,
    dpi: int | None = None,
    detect: bool = True,
    models: str | os.PathLike[str] | None = None,
    fonts: Iterable[str | os.PathLike[str]] = (),
    star: Iterable[int] = (),
    duplicate_threshold: int | None = None,
    keep_all: bool = False,
    as_given: bool = False,
    skip_broken: bool = False,
    whole_photos: bool = False,
    places: bool = True,
) -> list[Page]: ...
@overload
def render(
    photos: _Photo | Iterable[_Photo],
    *,
    layout: str | _Json | None = None,
    style: str | _Json | None = None,
    panels: int | None = None,
    pages: None = None,
    seed: int = 1,
    page_size: str | tuple[int, int] | None = None,
    width: int | None = None,
    dpi: int | None = None,
    gutter: float | None = None,
    margin: float | None = None,
    border: float | None = None,
    corner_radius: float | None = None,
    paper: str | None = None,
    border_color: str | None = None,
    merge: bool = False,
    whole_photos: bool = False,
    detect: bool = True,
    models: str | os.PathLike[str] | None = None,
    words: Sequence[_Json] | None = None,
    edits: Sequence[_Json] | None = None,
    fonts: Iterable[str | os.PathLike[str]] = (),
    star: Iterable[int] = (),
    duplicate_threshold: int | None = None,
    keep_all: bool = False,
    as_given: bool = False,
    skip_broken: bool = False,
) -> Page: ...
@overload
def render(
    photos: _Photo | Iterable[_Photo],
    *,
    layout: str | _Json | None = None,
    style: str | _Json | None = None,
    panels: int | None = None,
    pages: int,
    seed: int = 1,
    page_size: str | tuple[int, int] | None = None,
    width: int | None = None,
    dpi: int | None = None,
    gutter: float | None = None,
    margin: float | None = None,
    border: float | None = None,
    corner_radius: float | None = None,
    paper: str | None = None,
    border_color: str | None = None,
    merge: bool = False,
    whole_photos: bool = False,
    detect: bool = True,
    models: str | os.PathLike[str] | None = None,
    words: Sequence[_Json] | None = None,
    edits: Sequence[_Json] | None = None,
    fonts: Iterable[str | os.PathLike[str]] = (),
    star: Iterable[int] = (),
    duplicate_threshold: int | None = None,
    keep_all: bool = False,
    as_given: bool = False,
    skip_broken: bool = False,
) -> list[Page]: ...
def pdf(pages: Iterable[Page], *, title: str = "", language: str = "en") -> bytes: ...
def styles() -> list[_Json]: ...
def layouts() -> list[_Json]: ...
def blocks() -> list[_Json]: ...
