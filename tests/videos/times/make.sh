#!/bin/sh
# Makes the films of this folder with ffmpeg 5.1: a generated test picture with two cuts, 64 x 48 pixels.
set -eu
cd "$(dirname "$0")"
picture() {
  echo "testsrc=s=64x48:r=$1:d=1,hue=h=0[a];smptebars=s=64x48:r=$1:d=1[b];testsrc2=s=64x48:r=$1:d=1[c];[a][b][c]concat=n=3"
}
film() {
  rate=$1
  shift
  ffmpeg -v error -y -f lavfi -i "$(picture "$rate")" -c:v libx264 -crf 34 -pix_fmt yuv420p -g 12 -bitexact "$@"
}
# A camera's timecode, counted in drop-frame.
film 30000/1001 -timecode '10:00:59;20' -movflags +faststart drop.mov
# Timecode without drop-frame, and the index of the file after its frames.
film 25 -timecode '23:59:58:12' day.mp4
# A transport stream, whose first picture has a time of 11.4 seconds.
film 25 -output_ts_offset 10 late.ts
# Two seconds of sound before the first picture, by an edit list.
ffmpeg -v error -y -f lavfi -i 'sine=d=5:r=8000' -itsoffset 2 -f lavfi -i "$(picture 25)" -map 1:v -map 0:a \
  -c:v libx264 -crf 34 -pix_fmt yuv420p -g 12 -fps_mode passthrough -c:a aac -b:a 8k -bitexact late.mp4
