/// The annotations that lie over the film's picture: where they are, when, and what a place of the
/// pointer means for them. Fractions of the picture, from its upper left corner.
import type { AnnotationBox, AnnotationEnd, ShotAnnotation } from '../protocol';

export interface PictureAnnotation extends ShotAnnotation {
    box: AnnotationBox;
}

const kStep = 0.001; // of the picture, that places are written with

function isPast(end: AnnotationEnd, filmTime: number, sceneTime: number): boolean {
    return (end.is_scene_time ? sceneTime : filmTime) >= end.time;
}

/// Whether it is drawn at these times, as far as `from` and `to` say.
export function isDrawnAt(
    { from, to }: Pick<ShotAnnotation, 'from' | 'to'>, filmTime: number, sceneTime: number,
): boolean {
    return (!from || isPast(from, filmTime, sceneTime)) && (!to || !isPast(to, filmTime, sceneTime));
}

const kOnPicture = new Set(['text', 'title', 'tip', 'plan', 'image']);

/// Whether it has a place in the scene, not on the picture.
export function isInScene({ kind }: Pick<ShotAnnotation, 'kind'>): boolean {
    return !kOnPicture.has(kind);
}

/// Those that have a box.
export function onPicture(all: readonly ShotAnnotation[]): PictureAnnotation[] {
    return all.flatMap((one) => one.box ? [{ ...one, box: one.box }] : []);
}

/// The one at a place: that which is drawn last.
export function annotationAt(
    all: readonly PictureAnnotation[], x: number, y: number,
): PictureAnnotation | undefined {
    return all.findLast(({ box: { centre, size } }) =>
        Math.abs(x - centre[0]) <= size[0] / 2 && Math.abs(y - centre[1]) <= size[1] / 2);
}

/// The centre of a box that is moved by a part of the picture: it stays on the picture, as far as
/// it fits.
export function movedCentre({ centre, size }: AnnotationBox, dx: number, dy: number): [number, number] {
    const moved = (from: number, by: number, extent: number) => {
        const margin = Math.min(extent / 2, 0.5);
        const to = Math.min(Math.max(from + by, margin), 1 - margin);
        return Number((Math.round(to / kStep) * kStep).toFixed(3));
    };
    return [moved(centre[0], dx, size[0]), moved(centre[1], dy, size[1])];
}
