/// The times of the shot's own events: strikes, impulses, forces.
import type { ShotState } from '../../protocol';
import { resolved } from '../axis';
import { sceneClock } from '../clock_text';
import type { Layout } from '../layout';
import type { Handle } from './handle';

/// The handles of all events with a time of their own; those that something else triggers have none.
export function eventHandles(layout: Layout, shot: ShotState): Handle[] {
    const { events, scene } = layout;
    return shot.events.filter((event) => !event.triggered).map((event) => ({
        id: event.path.join('/'), path: event.path, axis: scene, time: event.time,
        y: events.y + 5, value: null, mark: 'action', colour: 'event', reach: { x: 7, y: 6 },
        step: { time: Math.max(resolved(scene, event.time).step, 0.01), value: 0 },
        label: `time of the ${event.kind} of ${event.object}`, text: sceneClock(event.time),
        change: (time) => {
            const { time: value, step } = resolved(scene, Math.max(0, time));
            return [{ path: [...event.path, event.kind, 'at'], value, precision: step }];
        },
    }));
}
