/// The paths of the objects that move, as lines in their colours with a dot for each tenth of a
/// second, and those that were pinned to compare with, in grey.
import { effect } from '@preact/signals';
import {
    BufferGeometry, DataTexture, Float32BufferAttribute, LinearFilter, LineBasicMaterial,
    LineSegments, Points, PointsMaterial,
} from 'three';
import { tracks } from '../motion/clock';
import { wish } from '../solve/solve_state';
import { onCommand } from '../state/keys';
import { dragging, hasErrors, isDeferred, sceneTime, shot, timeline } from '../state/state';
import { showTrails } from '../state/view_state';
import { kColours } from './gizmos/figure';
import { pinned, pinnedBalls, togglePin } from './gizmos/pinned';
import { forTests, sketchOf } from './gizmos/sketch';
import { kDrawingPriority, type MakePart } from './parts';
import { secondContacts, trailShapes, type TrailShapes } from './trail_lines';

const kStaleColour = 0x808890;
const kStyle = { opacity: 0.75, fadedOpacity: 0.75 };
const kDragStyle = { opacity: 1, fadedOpacity: 0.2 };
const kPinnedStyle = { opacity: 0.6, fadedOpacity: 0.6 };

/// A white disc with a soft edge.
function disc(): DataTexture {
    const size = 16;
    const pixels = new Uint8Array(4 * size * size).fill(255);
    for (let i = 0; i < size * size; ++i) {
        const [x, y] = [(i % size) - (size - 1) / 2, Math.floor(i / size) - (size - 1) / 2];
        const inside = size / 2 - Math.hypot(x, y);
        pixels[4 * i + 3] = 255 * Math.min(1, Math.max(0, inside / 4));
    }
    const texture = new DataTexture(pixels, size, size);
    texture.magFilter = LinearFilter;
    texture.minFilter = LinearFilter;
    texture.needsUpdate = true;
    return texture;
}

/// Two drawing calls for any number of paths.
class Trails {
    readonly lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial({
        vertexColors: true, transparent: true, depthWrite: false,
    }));
    readonly dots = new Points(new BufferGeometry(), new PointsMaterial({
        vertexColors: true, transparent: true, size: 4.5, sizeAttenuation: false, map: disc(),
        depthWrite: false,
    }));

    constructor() {
        this.lines.frustumCulled = false;
        this.dots.frustumCulled = false;
    }

    update({ lines, lineColours, dots, dotColours }: TrailShapes): void {
        const set = (object: LineSegments | Points, places: number[], colours: number[]) => {
            object.geometry.dispose();
            object.geometry = new BufferGeometry()
                .setAttribute('position', new Float32BufferAttribute(places, 3))
                .setAttribute('color', new Float32BufferAttribute(colours, 4));
        };
        set(this.lines, lines, lineColours);
        set(this.dots, dots, dotColours);
    }

    dispose(): void {
        for (const drawn of [this.lines, this.dots]) {
            drawn.removeFromParent();
            drawn.geometry.dispose();
            drawn.material.dispose();
        }
        this.dots.material.map?.dispose();
    }

    show(isShown: boolean, hasDots = isShown): void {
        this.lines.visible = isShown;
        this.dots.visible = hasDots;
    }

    /// One colour for all, or their own.
    setColour(colour: number | null): void {
        for (const { material } of [this.lines, this.dots]) {
            material.vertexColors = colour === null;
            material.color.set(colour ?? 0xffffff);
            material.opacity = colour === null ? 1 : 0.75;
            material.needsUpdate = true;
        }
    }
}

export const makeTrails: MakePart = (context) => {
    const { scene, ask } = context;
    const sketch = sketchOf(context);
    const trails = new Trails();
    const old = new Trails();
    old.setColour(kColours.pinned);
    scene.add(trails.lines, trails.dots, old.lines);
    forTests['trails'] = () => ({
        pieces: (trails.lines.geometry.getAttribute('position')?.count ?? 0) / 2,
        dots: trails.dots.geometry.getAttribute('position')?.count ?? 0,
        opacities: [...new Set([...(trails.lines.geometry.getAttribute('color')?.array ?? [])]
            .filter((_, i) => i % 4 === 3))],
        isGrey: !trails.lines.material.vertexColors,
        pinnedPieces: old.lines.visible
            ? (old.lines.geometry.getAttribute('position')?.count ?? 0) / 2 : 0,
    });
    const ends = [
        effect(() => {
            const isDragged = dragging.value;
            const faded = secondContacts(isDragged ? timeline.value?.head.events ?? [] : []);
            trails.update(trailShapes(shot.value?.objects ?? [], tracks.value,
                isDragged ? kDragStyle : kStyle, faded));
            ask();
        }),
        effect(() => {
            // The paths of the last valid texts stay; those that come in a moment are not worth it.
            trails.setColour(hasErrors.value || isDeferred.value ? kStaleColour : null);
            ask();
        }),
        effect(() => {
            const one = pinned.value;
            if (one) {
                old.update(trailShapes(one.objects, one.tracks, kPinnedStyle, new Map()));
            }
            trails.show(showTrails.value && wish.value === null);
            old.show(showTrails.value && one !== null);
            ask();
        }),
        effect(() => {
            sketch.show('pinned', {
                balls: pinned.value ? pinnedBalls(sceneTime.value) : [],
            }, 'moving');
        }),
        onCommand('pinGhost', togglePin),
    ];
    return {
        priority: kDrawingPriority,
        dispose: () => {
            ends.forEach((end) => end());
            trails.dispose();
            old.dispose();
            sketch.dispose();
        },
    };
};
