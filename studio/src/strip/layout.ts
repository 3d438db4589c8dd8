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
    clips: Row;
    curve: Row;
    map: Row;
    energy: Row;
    events: Row;
    sceneRuler: Row;
    film: Axis;
    scene: Axis;
}

/// Width of the column of labels, px.
export const kLabels = 76;
const kRight = 10;
const kRuler = 20;

/// The rows in a canvas of this size (px); film time is above, scene time below.
export function layoutOf(width: number, height: number, film: Range, scene: Range): Layout {
    const left = kLabels;
    const inner = Math.max(40, width - kLabels - kRight);
    const free = Math.max(90, height - 2 * kRuler);
    const heights = [
        kRuler, Math.round(Math.min(34, 0.2 * free)), Math.round(0.22 * free), 0,
        Math.round(0.2 * free), Math.round(Math.min(30, 0.17 * free)), kRuler,
    ];
    const used = heights.reduce((sum, part) => sum + part, 0);
    heights[3] = Math.max(16, height - used);
    let y = 0;
    const rows = heights.map((part) => {
        const row = { y, height: part };
        y += part;
        return row;
    });
    const none = { y: 0, height: 0 };
    return {
        width, height,
        filmRuler: rows[0] ?? none, clips: rows[1] ?? none, curve: rows[2] ?? none,
        map: rows[3] ?? none, energy: rows[4] ?? none, events: rows[5] ?? none,
        sceneRuler: rows[6] ?? none,
        film: { ...film, left, width: inner },
        scene: { ...scene, left, width: inner },
    };
}

/// Whether a height belongs to film time (else to scene time); the middle of the map is the border.
export function isFilmSide(layout: Layout, y: number): boolean {
    return y < layout.map.y + layout.map.height / 2;
}
