"""What OpenTimelineIO reads in the lists of `tests/oracles/data/shots/`, for `tests/shots.rs`.

    pip install opentimelineio==0.18.1 otio-cmx3600-adapter==1.0.0 otio-fcp-adapter==1.0.0
    python tests/oracles/shots.py

Writes `tests/oracles/data/shots.json`: of each file the shots in their order, each with its first frame in its film, its first
frame in the programme, and how many frames it has.
"""

import json
import pathlib

import opentimelineio as otio

DATA = pathlib.Path(__file__).parent / "data"


def frames(time, rate):
    exact = time.rescaled_to(rate)
    assert exact.value == int(exact.value), time
    return int(exact.value)


def read(path):
    rate = int(path.stem.split("-")[1])
    more = {"rate": rate} if path.suffix == ".edl" else {}
    if path.suffix == ".xml":
        more["adapter_name"] = "fcp_xml"
    timeline = otio.adapters.read_from_file(str(path), **more)
    if isinstance(timeline, otio.schema.SerializableCollection):
        timeline = timeline[0]
    (track,) = timeline.video_tracks()
    shots = []
    for clip in track.find_clips():
        assert clip.source_range.duration.rate == rate, clip
        placed = clip.transformed_time_range(clip.trimmed_range(), timeline.tracks)
        media = clip.media_reference
        shots.append({
            "start": frames(clip.source_range.start_time, rate),
            "frames": frames(clip.source_range.duration, rate),
            "at": frames(placed.start_time, rate),
            "media": getattr(media, "name", "") or clip.name,
        })
    # In a decision list the programme begins at one hour.
    assert shots[0]["at"] == (3600 * rate if path.suffix == ".edl" else 0), shots[0]
    begin = shots[0]["at"]
    return [{**shot, "at": shot["at"] - begin} for shot in shots]


def main():
    told = {path.name: read(path) for path in sorted((DATA / "shots").iterdir()) if path.suffix != ".csv"}
    text = json.dumps(told, indent=1, ensure_ascii=False)
    (DATA / "shots.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
