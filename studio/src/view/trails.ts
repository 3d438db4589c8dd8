/// The paths of the objects that move, as lines in their colours.
import { effect } from '@preact/signals';
import {
    BufferGeometry, Color, Float32BufferAttribute, LineBasicMaterial, LineSegments,
} from 'three';
import { tracks } from '../motion/clock';
import type { Track } from '../motion/track';
import type { SceneObject, Triple } from '../protocol';
import { isStale, shot } from '../state/state';
import { showTrails } from '../state/view_state';
import { kDrawingPriority, type MakePart } from './parts';

const kMostPieces = 24; // straight pieces between two keys
const kDeviation = 0.0005; // m, of the drawn line from the curve
const kStaleColour = 0x808890;

/// Into how many straight pieces a curve between two keys is cut: a piece deviates by at most an
/// eighth of the square of its share of the curve times the second derivative.
function countPieces([a, b, c, d]: [Triple, Triple, Triple, Triple]): number {
    const bend = (p: Triple, q: Triple, r: Triple) =>
        6 * Math.hypot(p[0] - 2 * q[0] + r[0], p[1] - 2 * q[1] + r[1], p[2] - 2 * q[2] + r[2]);
    const pieces = Math.sqrt(Math.max(bend(a, b, c), bend(b, c, d)) / (8 * kDeviation));
    return Math.min(Math.max(1, Math.ceil(pieces)), kMostPieces);
}

/// Points along a track, x, y, z each.
export function polyline(track: Track): number[] {
    const points = [...track.positionOf(0)];
    for (let key = 0; key + 1 < track.keys; ++key) {
        const pieces = countPieces(track.bezierAfter(key));
        const from = track.timeOf(key);
        const span = track.timeOf(key + 1) - from;
        for (let piece = 1; piece < pieces; ++piece) {
            points.push(...track.position(from + (span * piece) / pieces));
        }
        points.push(...track.positionOf(key + 1));
    }
    return points;
}

/// One drawing call for all trails.
export class Trails {
    readonly lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({
        vertexColors: true, transparent: true, opacity: 0.75,
    }));

    constructor() {
        this.lines.frustumCulled = false;
    }

    /// Draws the trails anew.
    update(objects: readonly SceneObject[], tracks: ReadonlyMap<string, Track>): void {
        const points: number[] = [];
        const colours: number[] = [];
        for (const object of objects.filter((one) => one.moves)) {
            const track = tracks.get(object.name);
            const line = track ? polyline(track) : [];
            const colour = new Color(...object.colour).lerp(new Color(1, 1, 1), 0.25);
            for (let i = 0; i + 5 < line.length; i += 3) {
                points.push(...line.slice(i, i + 6));
                colours.push(...colour.toArray(), ...colour.toArray());
            }
        }
        this.lines.geometry.dispose();
        this.lines.geometry = new BufferGeometry()
            .setAttribute('position', new Float32BufferAttribute(points, 3))
            .setAttribute('color', new Float32BufferAttribute(colours, 3));
    }

    /// Greys the trails while they belong to older texts.
    setStale(stale: boolean): void {
        const { material } = this.lines;
        material.vertexColors = !stale;
        material.color.set(stale ? kStaleColour : 0xffffff);
        material.needsUpdate = true;
    }
}

export const makeTrails: MakePart = ({ scene, ask }) => {
    const trails = new Trails();
    scene.add(trails.lines);
    const ends = [
        effect(() => {
            trails.update(shot.value?.objects ?? [], tracks.value);
            ask();
        }),
        effect(() => {
            trails.setStale(isStale.value);
            ask();
        }),
        effect(() => {
            trails.lines.visible = showTrails.value;
            ask();
        }),
    ];
    return {
        priority: kDrawingPriority,
        dispose: () => {
            ends.forEach((end) => end());
            trails.lines.removeFromParent();
        },
    };
};
