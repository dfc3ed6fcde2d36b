"""Films as files: GIF and MP4, encoded by the ffmpeg that the package imageio-ffmpeg brings."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from subprocess import PIPE
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from carom import checks
from carom.draw.film.film import Film
from carom.errors import CaromError, MissingExtra
from carom.extras import needed
from carom.spelling import spelled

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

#: Frames a second. A GIF's frames last whole hundredths of a second, and 20 a second are every third step of 1/60 s.
RATES = {".gif": 20, ".mp4": 60}
#: From how many frames a GIF's colours are chosen, at most.
MOST_SAMPLES = 24
#: Frames whose time is later than a recorded one by less than this, in seconds, are of that one.
ROUNDING = 1e-6
#: How MP4 is encoded: for every player, with the colours of screens; its sides must be even numbers of pixels.
MP4 = {
    "-vf": "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709",
    "-c:v": "libx264",
    "-preset": "medium",
    "-crf": "18",
    "-pix_fmt": "yuv420p",
    "-colorspace": "bt709",
    "-movflags": "+faststart",
    "-f": "mp4",
}
#: How the colours of a GIF are chosen, and how they are used: the nearest for each pixel. It plays for ever.
PALETTE = {"-vf": "palettegen=max_colors=255:reserve_transparent=1:stats_mode=full", "-update": "1"}
GIF = {"-lavfi": "paletteuse=dither=none:diff_mode=rectangle", "-loop": "0", "-f": "gif"}
#: The same bytes every time, as far as the encoder goes.
PLAIN = {"-map_metadata": "-1", "-fflags": "+bitexact", "-flags:v": "+bitexact"}


class EncodingError(CaromError):
    """A film could not be encoded; the message is the encoder's."""


def encoder() -> str:
    """The path of the ffmpeg that encodes; raises `MissingExtra` where there is none."""
    module = needed("imageio_ffmpeg", "imageio-ffmpeg", "draw", "animations")
    try:
        path: str = module.get_ffmpeg_exe()
    except RuntimeError:
        raise MissingExtra("animations need ffmpeg, which imageio-ffmpeg does not bring for this machine") from None
    return path


@spelled
def write_film(
    film: Film | Sequence[Film], path: str | os.PathLike[str], tell: Callable[[int, int], Any] | None = None
) -> None:
    """Write a `.gif` or `.mp4` file that plays a film as fast as it happened.

    Args:
        film: The film, or films of one size, which then follow each other.
        path: The file; it is there in part while this goes on, and if it fails.
        tell: Called with the frames done and the frames in all, after each.

    Raises:
        EncodingError: The encoder failed, of a full disk for example.
        InvalidArgument: The file has another ending, or there are no films, or films of different sizes.
        MissingExtra: There is no encoder.
    """
    target = Path(checks.path("path", path))
    ending = target.suffix.lower()
    if ending not in RATES:
        raise checks.refuse("path", f"must end in {' or '.join(RATES)}", str(target))
    films = [checks.instance("film", one, Film, "a Film, or several") for one in films_of(film)]
    checks.callable_or_none("tell", tell)
    sizes = [one.pixels for one in films]
    if len(set(sizes)) != 1:
        raise checks.refuse("film", "must be one or several of the same size", sizes)
    frames = [(one, frame) for one in films for frame in frames_of(one, RATES[ending])]

    def pictures() -> Iterable[bytes]:
        for done, (one, frame) in enumerate(frames, 1):
            yield one.rgb(frame)
            if tell is not None:
                tell(done, len(frames))

    if ending == ".mp4":
        encode(sizes[0], RATES[ending], pictures(), MP4, target)
        return
    with TemporaryDirectory() as folder:
        palette = Path(folder) / "palette.png"
        samples = frames[:: max(1, -(-len(frames) // MOST_SAMPLES))]
        encode(sizes[0], 1, (one.rgb(frame) for one, frame in samples), PALETTE, palette)
        encode(sizes[0], RATES[ending], pictures(), {"-i": f"file:{palette}"} | GIF, target)


def films_of(film: Any) -> list[Any]:
    """The films that are given: one, or several in a sequence."""
    return list(film) if isinstance(film, Sequence) and not isinstance(film, (str, bytes)) else [film]


def frames_of(film: Film, rate: int) -> list[int]:
    """The recorded frames to show, `rate` a second."""
    recording = film.recording
    count = int(recording.duration * rate + ROUNDING) + 1
    return [recording.frame_at(recording.times[0] + number / rate + ROUNDING) for number in range(count)]


def encode(size: tuple[int, int], rate: int, pictures: Iterable[bytes], options: Mapping[str, str], path: Path) -> None:
    """Give pictures of a size to the encoder, which writes a file as its `options` say."""
    width, height = size
    source = {"-f": "rawvideo", "-pix_fmt": "rgb24", "-s": f"{width}x{height}", "-r": str(rate), "-i": "-"}
    words = (word for table in (source, options, PLAIN) for pair in table.items() for word in pair)
    command = [encoder(), "-y", "-nostdin", "-loglevel", "error", *words, f"file:{path}"]
    # In a session of its own, where Ctrl-C does not reach it: who gives it pictures decides what becomes of it.
    with subprocess.Popen(
        command, stdin=PIPE, stdout=subprocess.DEVNULL, stderr=PIPE, start_new_session=True
    ) as process:
        assert process.stdin is not None
        try:
            # An encoder that failed has closed its end; what it has to say is read below.
            with suppress(BrokenPipeError):
                for picture in pictures:
                    process.stdin.write(picture)
            _, told = process.communicate()
        except BaseException:
            process.kill()
            raise
    if process.returncode != 0:
        lines = told.decode("utf-8", "replace").strip().splitlines()
        raise EncodingError(reason(lines) if lines else f"ffmpeg failed with status {process.returncode}")


def reason(lines: list[str]) -> str:
    """Why the encoder failed, of the lines that it wrote: the system's reason where it names one, else the last."""
    for line in lines:
        _, found, rest = line.rpartition(": ")
        if found and rest in {"No space left on device", "Permission denied", "No such file or directory"}:
            return rest
    return lines[-1]
