/// When the selected annotation appears and disappears: on the clock on which it says so.
import { sourceOf } from '../../edit/edit';
import { parseMoment } from '../../motion/moments';
import { annotationName } from '../../outline/annotation_name';
import type { AnnotationEnd, KeyPath, ShotAnnotation, ShotState } from '../../protocol';
import { resolved } from '../axis';
import { filmClock, sceneClock } from '../clock_text';
import { oldTexts, timeChange as filmTimeChange, timeOfFrame } from '../film_time';
import type { Layout } from '../layout';
import { frameNear, type Handle } from './handle';
import { timeChange } from './map_handles';

const kLongest = 3600; // s

/// Whether it is a time of the scene; also that of a moment, which the film shows some time.
function isOfScene(end: AnnotationEnd): boolean {
    return end.is_scene_time || end.moment !== undefined;
}

/// The least and the largest time of an end, so that it stays before or after the other one.
function limits(annotation: ShotAnnotation, key: 'from' | 'to', step: number): [number, number] {
    const own = annotation[key];
    const other = annotation[key === 'from' ? 'to' : 'from'];
    if (!own || !other || isOfScene(other) !== isOfScene(own)) {
        return [0, kLongest];
    }
    const time = other.moment ?? other.time;
    return key === 'from' ? [0, Math.max(0, time - step)] : [time + step, kLongest];
}

function sceneHandle(
    layout: Layout, annotation: ShotAnnotation, key: 'from' | 'to', end: AnnotationEnd,
): Handle {
    const { scene, events } = layout;
    const path: KeyPath = [...annotation.path, key];
    const step = Math.max(resolved(scene, end.time).step, 0.001);
    const written = sourceOf(path)?.text;
    const isMoment = written !== undefined && parseMoment(written) !== null;
    const [least, most] = limits(annotation, key, step);
    return {
        ...common(annotation, key, end, step), axis: scene, y: events.y + events.height - 5,
        text: `${isMoment ? `${written} ` : ''}${sceneClock(end.time)}`,
        change: (next) =>
            [timeChange(path, scene, Math.min(Math.max(next, least), most), written, end.time)],
    };
}

function filmHandle(
    layout: Layout, annotation: ShotAnnotation, key: 'from' | 'to', end: AnnotationEnd, fps: number,
): Handle {
    const { film, clips } = layout;
    const old = oldTexts();
    const [least, most] = limits(annotation, key, 1 / fps);
    return {
        ...common(annotation, key, end, 1 / fps), axis: film, y: clips.y + clips.height - 5,
        text: filmClock(end.time),
        change: (next) => [filmTimeChange([...annotation.path, key],
            timeOfFrame(frameNear(next, fps, least, most), fps), old)],
    };
}

function common(annotation: ShotAnnotation, key: 'from' | 'to', end: AnnotationEnd, step: number) {
    return {
        id: `${annotation.path.join('/')} ${key}`, path: annotation.path, time: end.time, value: null,
        mark: 'tick' as const, colour: 'accent', reach: { x: 6, y: 6 }, step: { time: step, value: 0 },
        label: `${key === 'from' ? 'start' : 'end'} of ${annotationName(annotation)}`,
    };
}

/// The handles of the annotation with that index, of the ends that its text has.
export function annotationHandles(layout: Layout, shot: ShotState, index: number): Handle[] {
    const annotation = shot.annotations[index];
    return annotation ? (['from', 'to'] as const).flatMap((key) => {
        const end = annotation[key];
        // A moment is dragged where it is in the scene, whenever the film first shows it.
        return !end ? [] : [isOfScene(end)
            ? sceneHandle(layout, annotation, key, { ...end, time: end.moment ?? end.time })
            : filmHandle(layout, annotation, key, end, shot.film.fps)];
    }) : [];
}
