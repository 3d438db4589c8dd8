/// Where the rows of the strip are.
import type { Axis, Range } from './axis';

/// A row: its upper border and its height, px.
export interface Row {
    y: number;
    height: number;
}

export interface Layout {
    width: number;
    height: number;
    filmRuler: Row;
    frames: Row; // small pictures of the film; of height 0 without any
    clips: Row;
    sound: Row; // of height 0 without any
    curve: Row;
    map: Row;
    motion: Row;
    events: Row;
    sceneRuler: Row;
    film: Axis;
    scene: Axis;
}

/// Width of the column of labels, px.
export const kLabels = 76;
const kRight = 10;
const kRuler = 20;
const kFrames = 34;
const kPartsSound = 36; // of a film of several shots

/// The rows in a canvas of this size (px); film time is above, scene time below.
export function layoutOf(
    width: number, height: number, film: Range, scene: Range, hasFrames = false, hasSound = false,
): Layout {
    const left = kLabels;
    const inner = Math.max(40, width - kLabels - kRight);
    const frames = hasFrames && height > 170 ? kFrames : 0;
    const rows = height - 2 * kRuler - frames;
    const sound = hasSound && rows > 110 ? Math.round(Math.min(48, Math.max(22, 0.16 * rows))) : 0;
    const free = Math.max(90, height - 2 * kRuler - frames - sound);
    const clips = Math.round(Math.min(30, Math.max(18, 0.17 * free)));
    const events = Math.round(Math.min(36, Math.max(16, 0.16 * free)));
    const motion = Math.round(0.22 * free);
    const curve = Math.round(0.26 * free);
    const map = Math.max(16, height - 2 * kRuler - frames - sound - clips - events - motion - curve);
    let y = 0;
    const row = (part: number): Row => {
        y += part;
        return { y: y - part, height: part };
    };
    return {
        width, height, filmRuler: row(kRuler), frames: row(frames), clips: row(clips),
        sound: row(sound), curve: row(curve), map: row(map), motion: row(motion), events: row(events),
        sceneRuler: row(kRuler),
        film: { ...film, left, width: inner },
        scene: { ...scene, left, width: inner },
    };
}

/// The rows for a film of several shots: the parts have all of the height, and there is no scene.
export function layoutOfParts(
    width: number, height: number, film: Range, hasFrames: boolean, hasSound = false,
): Layout {
    const inner = Math.max(40, width - kLabels - kRight);
    const axis = { ...film, left: kLabels, width: inner };
    const frames = hasFrames && height > 130 ? kFrames : 0;
    const top = kRuler + frames;
    const sound = hasSound && height - top > 60 ? kPartsSound : 0;
    const clips = Math.max(30, height - top - sound);
    const none = { y: height, height: 0 };
    return {
        width, height, filmRuler: { y: 0, height: kRuler }, frames: { y: kRuler, height: frames },
        clips: { y: top, height: clips }, sound: { y: top + clips, height: sound },
        curve: none, map: none, motion: none, events: none, sceneRuler: none, film: axis, scene: axis,
    };
}

const kLane = 60; // px, the largest height of a lane
const kLanesApart = 6;

/// Where parts are drawn: by turns in two lanes, so that those that fade into each other stand one
/// above the other.
export function laneOf(row: Row, index: number): Row {
    const height = Math.min(kLane, (row.height - kLanesApart) / 2);
    return { y: row.y + kLanesApart / 2 + (index % 2) * height, height: height - 3 };
}

/// Whether a height belongs to film time (else to scene time); the middle of the map is the border.
export function isFilmSide(layout: Layout, y: number): boolean {
    return y < layout.map.y + layout.map.height / 2;
}

export function isIn(row: Row, y: number): boolean {
    return y >= row.y && y < row.y + row.height;
}
