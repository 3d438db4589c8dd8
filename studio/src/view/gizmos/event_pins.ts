/// Pins in space for the first contact after each strike and for balls that are potted or leave the
/// table. Pointing at one shows what happened; a click goes to its time.
import { computed, effect, signal } from '@preact/signals';
import { goToSceneTime } from '../../motion/clock';
import type { TimelineEvent, Triple } from '../../protocol';
import { fan, isStale, shot, timeline } from '../../state/state';
import { showTrails } from '../../state/view_state';
import { kGizmoPriority, type MakePart } from '../parts';
import { isNear, nearestHandle } from './dragging';
import { fanText } from './fan_text';
import { isFanShown } from './fan_state';
import { kColours, type Figure, type Label } from './figure';
import { forTests, sketchOf } from './sketch';

const kHeight = 0.075; // m, of a pin's head above the place
const kClickDistance = 4; // CSS pixels

export interface Pin {
    event: TimelineEvent;
    at: Triple;
}

/// The events that have a pin: of `bodies` are the names of balls and objects.
export function pinsOf(events: readonly TimelineEvent[], bodies: ReadonlySet<string>): Pin[] {
    let isAwaited = false; // a contact after a strike
    return events.filter((event) => {
        if (event.kind === 'strike') {
            isAwaited = true;
        }
        const isFirst = isAwaited && event.kind === 'impact' && bodies.has(event.a)
            && bodies.has(event.b);
        isAwaited &&= !isFirst;
        return isFirst || event.kind === 'potted' || event.kind === 'off_table';
    }).map((event) => {
        const [x, y, z] = event.place;
        return { event, at: [x, y, Math.max(z, 0) + kHeight] };
    });
}

/// The pins of the newest motion.
export const pins = computed<Pin[]>(() => {
    if (!showTrails.value) {
        return [];
    }
    const bodies = (shot.value?.objects ?? []).filter(({ kind }) => kind !== 'table');
    return pinsOf(timeline.value?.head.events ?? [], new Set(bodies.map(({ name }) => name)));
});

/// The pin at the pointer.
const pointed = signal<Pin | null>(null);

function pinFigure(all: readonly Pin[], under: Pin | null, sure: readonly Label[]): Figure {
    const colourOf = ({ event }: Pin) => event.kind === 'potted' ? kColours.potted
        : event.kind === 'impact' ? kColours.contact : kColours.wrong;
    return {
        lines: all.map((pin) => ({
            from: pin.event.place, to: pin.at, colour: colourOf(pin), isFaint: pin !== under,
        })),
        dots: all.map((pin) => ({
            at: pin.at, colour: colourOf(pin), size: pin === under ? 12 : 9,
            shape: pin.event.kind === 'impact' ? 'disc' : 'diamond',
        })),
        labels: [...sure, ...(under ? [{
            at: under.at, text: `${under.event.text}, ${under.event.time.toFixed(3)} s`,
        }] : [])],
    };
}

export const makeEventPins: MakePart = (context) => {
    const sketch = sketchOf(context);
    forTests['pins'] = () => pins.peek();
    const ends = [effect(() => {
        const under = pointed.value;
        const all = pins.value;
        const isKept = under !== null && all.includes(under);
        const answer = isFanShown.value && !isStale.value ? fan.value : null;
        const sure = fanText(answer, all, shot.value?.pockets ?? []);
        sketch.show('pins', pinFigure(all, isKept ? under : null, sure));
    })];
    // A ball under a pin comes first: it may be dragged.
    const pinAt = (event: PointerEvent) => {
        const pin = nearestHandle(context, pins.peek(), event);
        return pin && context.objectAt(event)?.kind !== 'ball' ? pin : null;
    };
    const leave = () => { pointed.value = null; };
    context.canvas.addEventListener('pointerleave', leave);
    return {
        priority: kGizmoPriority,
        grab: (start) => {
            const pin = pinAt(start);
            return pin && {
                move: () => {},
                end: (event) => {
                    if (isNear(context, pin.at, event, kClickDistance + 10)) {
                        goToSceneTime(pin.event.time);
                    }
                },
                cancel: () => {},
            };
        },
        hover: (event) => {
            pointed.value = pinAt(event);
            return pointed.value ? 'pointer' : null;
        },
        dispose: () => {
            ends.forEach((end) => end());
            context.canvas.removeEventListener('pointerleave', leave);
            sketch.dispose();
        },
    };
};
