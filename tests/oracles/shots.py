"""Reads the lists of `tests/oracles/data/shots/` with OpenTimelineIO, for `tests/shots.rs`.

    pip install opentimelineio==0.18.1 otio-cmx3600-adapter==1.0.0 otio-fcp-adapter==1.0.0
    python tests/oracles/shots.py

Writes `tests/oracles/data/shots.json` and `timecodes.json`. For each file, `shots.json` has the shots in
order. Each shot has its first frame in its video and in the timeline, its number of frames, the first frame
and the length of its video, and the reel or the address of the video. `timecodes.json` has the timecodes of
some frames at each rate.
"""

import json
import pathlib

import opentimelineio as otio

DATA = pathlib.Path(__file__).parent / "data"


# Frames per second, and whether the rate uses drop-frame timecode, by name.
RATES = {
    "24": (24, False),
    "25": (25, False),
    "30": (30, False),
    "23.976": (24000 / 1001, False),
    "29.97": (30000 / 1001, False),
    "29.97drop": (30000 / 1001, True),
}


def frames(time):
    assert abs(time.value - round(time.value)) < 1e-6, time
    return round(time.value)


def read(path):
    rate, drops = RATES[path.stem.removeprefix("list-")]
    more = {"rate": rate} if path.suffix == ".edl" else {}
    if path.suffix == ".xml":
        more["adapter_name"] = "fcp_xml"
    timeline = otio.adapters.read_from_file(str(path), **more)
    if isinstance(timeline, otio.schema.SerializableCollection):
        timeline = timeline[0]
    (track,) = timeline.video_tracks()
    shots = []
    for clip in track.find_clips():
        assert abs(clip.source_range.duration.rate - rate) < 1e-6, clip
        placed = clip.transformed_time_range(clip.trimmed_range(), timeline.tracks)
        media = clip.media_reference
        shot = {
            "start": frames(clip.source_range.start_time),
            "frames": frames(clip.source_range.duration),
            "at": frames(placed.start_time),
            "media": getattr(media, "name", "") or clip.name,
        }
        if path.suffix == ".edl":
            # The reader omits the reel of a clip without one.
            shot["source"] = clip.metadata["cmx_3600"].get("reel", "AX")
        else:
            shot["available"] = [frames(media.available_range.start_time), frames(media.available_range.duration)]
            shot["source"] = media.target_url
        shots.append(shot)
    # In a decision list the programme begins at one hour.
    begin = shots[0]["at"]
    hour = frames(otio.opentime.from_timecode("01:00:00;00" if drops else "01:00:00:00", rate))
    assert begin == (hour if path.suffix == ".edl" else 0), shots[0]
    return [{**shot, "at": shot["at"] - begin} for shot in shots]


def codes(rate, drops):
    """Frames around every minute of half an hour, some of the next day, and each with its code, which is read back."""
    around = [minute * round(rate * 60) + off for minute in range(31) for off in range(-40, 41, 8)]
    some = [*around, *range(0, 90), *range(107_880, 107_900), *range(150_000, 2_000_000, 98_765)]
    told = []
    for frame in sorted({frame for frame in some if frame >= 0}):
        code = otio.opentime.to_timecode(otio.opentime.RationalTime(frame, rate), rate, drops)
        assert frames(otio.opentime.from_timecode(code, rate)) == frame, (frame, code)
        told.append([frame, code])
    return told


def main():
    told = {path.name: read(path) for path in sorted((DATA / "shots").iterdir()) if path.suffix != ".csv"}
    text = json.dumps(told, indent=1, ensure_ascii=False)
    (DATA / "shots.json").write_text(text + "\n", encoding="utf-8")
    text = json.dumps({name: codes(*rate) for name, rate in RATES.items()}, separators=(",", ":"))
    (DATA / "timecodes.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
