"""Extracts frames of videos as PNG files, for the table of near-duplicates: frames.py OUT STEP_MS VIDEOS...

Each is called FILM-MILLISECONDS.png; the first frame at or after each step is taken. Needs PyAV.
"""

import sys
from pathlib import Path

import av


def main() -> None:
    out, step = Path(sys.argv[1]), int(sys.argv[2])
    for name in sys.argv[3:]:
        with av.open(name) as film:
            due = 0
            for frame in film.decode(video=0):
                time = round(frame.time * 1000)
                if time < due:
                    continue
                due += step
                (out / f"{Path(name).stem}-{time:05}.png").write_bytes(png(frame))


def png(frame: av.VideoFrame) -> bytes:
    encoder = av.CodecContext.create("png", "w")
    encoder.width, encoder.height, encoder.pix_fmt = frame.width, frame.height, "rgb24"
    encoder.time_base = frame.time_base
    packets = encoder.encode(frame.reformat(format="rgb24")) + encoder.encode(None)
    return b"".join(bytes(packet) for packet in packets)


main()
