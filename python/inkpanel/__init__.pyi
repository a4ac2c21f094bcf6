import os
from collections.abc import Iterable, Sequence
from typing import Any, Union, final, overload

import numpy as np
from numpy.typing import NDArray
from typing_extensions import TypedDict, Unpack

__version__: str

_Pixels = NDArray[np.uint8]
_Photo = Union[str, os.PathLike[str], bytes, _Pixels]
_Json = dict[str, Any]

class _PageSettings(TypedDict, total=False):
    # `cargo xtask bless bounds` writes these lines.
    gutter: float | None
    margin: float | None
    border: float | None
    corner_radius: float | None
    rtl: bool | None
    whole_photos: bool | None
    paper: str | None
    border_color: str | None

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
    merge: bool = False,
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
    **page_settings: Unpack[_PageSettings],
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
    merge: bool = False,
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
    **page_settings: Unpack[_PageSettings],
) -> list[Page]: ...
def page_settings() -> dict[str, str]: ...
def pdf(pages: Iterable[Page], *, title: str = "", language: str = "en") -> bytes: ...
def styles() -> list[_Json]: ...
def layouts() -> list[_Json]: ...
def blocks() -> list[_Json]: ...
