/// What the strip shows of the times: its ranges, the filter of events, the curve. These are ways of
/// looking, not part of the shot.
import { computed, effect, signal } from '@preact/signals';
import { filmCamera, filmDuration } from '../motion/clock';
import type { Camera, TimelineEvent } from '../protocol';
import { sceneTime, selection, sequence, shot, timeline } from '../state/state';
import { kept, type Range } from './axis';

export type CurveName = 'speed' | 'fov' | 'focus' | 'aperture';
export type EventGroup = 'actions' | 'contacts' | 'cushions' | 'pockets' | 'rest' | 'changes';

export const kEventGroups: readonly { group: EventGroup; label: string; about: string }[] = [
    { group: 'actions', label: 'Actions', about: 'strikes, impulses, forces, balls put down' },
    { group: 'contacts', label: 'Contacts', about: 'balls and objects that hit each other' },
    { group: 'cushions', label: 'Cushions', about: 'hits of a cushion' },
    { group: 'pockets', label: 'Pockets', about: 'balls that are potted or leave the table' },
    { group: 'rest', label: 'Rest', about: 'balls that come to rest' },
    { group: 'changes', label: 'Motion', about: 'balls that begin to roll, slide, spin, fly or land' },
];

const kGroups: Record<string, EventGroup> = {
    strike: 'actions', impulse: 'actions', force: 'actions', torque: 'actions',
    velocity: 'actions', placed: 'actions', removed: 'actions', potted: 'pockets', off_table: 'pockets', resting: 'rest',
    sliding: 'changes', rolling: 'changes', spinning: 'changes', airborne: 'changes',
};

const kSurfaceGroups: Record<string, EventGroup> = {
    cushion: 'cushions', jaw: 'cushions', rail: 'cushions', cloth: 'changes', floor: 'changes',
};

/// What kind of event it is, for the filter and for its colour.
export function groupOf(event: TimelineEvent): EventGroup {
    if (event.kind === 'impact') {
        return kSurfaceGroups[event.b] ?? 'contacts';
    }
    return kGroups[event.kind] ?? 'changes';
}

/// The groups of events that are shown, and visited by [ and ].
export const shownGroups = signal<ReadonlySet<EventGroup>>(
    new Set<EventGroup>(['actions', 'contacts', 'cushions', 'pockets', 'rest']),
);
export const curveName = signal<CurveName>('speed');

/// The times of the axes that are zoomed in; null: everything.
export const filmRange = signal<Range | null>(null);
export const sceneRange = signal<Range | null>(null);

/// All times of the film and of the scene, with a margin that keeps the ends apart from the border.
export const wholeFilm = computed(() => withMargin({ from: 0, to: filmDuration.value || 1 }));
export const wholeScene = computed(() => {
    const head = timeline.value?.head;
    const from = head?.start ?? 0;
    return withMargin({ from, to: Math.max(head?.end ?? 1, from + 0.01) });
});

export const shownFilm = computed(() =>
    filmRange.value ? kept(filmRange.value, wholeFilm.value) : wholeFilm.value);
export const shownScene = computed(() =>
    sceneRange.value ? kept(sceneRange.value, wholeScene.value) : wholeScene.value);

function withMargin(range: Range): Range {
    const margin = 0.012 * (range.to - range.from);
    return { from: range.from - margin, to: range.to + margin };
}

/// The events that the filter lets through, in the order of time.
export const shownEvents = computed(() =>
    (timeline.value?.head.events ?? []).filter((event) => shownGroups.value.has(groupOf(event))));

/// The event that was gone to last. It counts as long as the scene's clock stands at it.
export const visitedEvent = signal<TimelineEvent | null>(null);

/// The event at the scene's clock: the one that was gone to, else the first of that time; null
/// between events.
export const currentEvent = computed(() => {
    const isNow = (event: TimelineEvent) => Math.abs(event.time - sceneTime.value) < 1e-9;
    const visited = visitedEvent.value;
    return visited && isNow(visited) && shownEvents.value.includes(visited)
        ? visited : shownEvents.value.find(isNow) ?? null;
});

/// The camera whose curve is shown: the selected one, else the one that the film shows.
export const curveCamera = computed<Camera | null>(() => {
    const cameras = shot.value?.cameras ?? [];
    const [section, index] = selection.value ?? [];
    const selected = section === 'cameras' ? cameras[Number(index)] : undefined;
    return selected ?? cameras[filmCamera.value] ?? null;
});

/// Shows all times of both axes.
export function fitStrip(): void {
    filmRange.value = null;
    sceneRange.value = null;
}

/// Shows all times again when another shot is opened. Returns a function that ends this.
export function fitOnNewShot(): () => void {
    let name: string | null = null;
    return effect(() => {
        const next = (shot.value ?? sequence.value)?.name ?? null;
        if (next !== name) {
            name = next;
            fitStrip();
        }
    });
}
