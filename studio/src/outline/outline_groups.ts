/// The tree of what a shot has, for the outline.
import type { KeyPath, ShotState } from '../protocol';

export interface OutlineItem {
    name: string;
    about: string;
    path: KeyPath;
}

export interface OutlineGroup {
    name: string;
    items: OutlineItem[];
}

/// The groups of a shot that are not empty, in the order of the text.
export function outlineGroups(shot: ShotState): OutlineGroup[] {
    const things = (kind: string) => shot.objects.filter((object) => object.kind === kind)
        .map(({ name, path, shape }) => ({ name, path, about: kind === 'ball' ? '' : shape }));
    const groups = [
        { name: 'Balls', items: things('ball') },
        { name: 'Objects', items: things('object') },
        {
            name: 'Events',
            items: shot.events.map(({ kind, object, path, time }) =>
                ({ name: `${kind} ${object}`, path, about: `${time.toFixed(2)} s` })),
        },
        {
            name: 'Cameras',
            items: shot.cameras.map(({ name, path, video_start, video_end }) =>
                ({ name, path, about: `${(video_end - video_start).toFixed(2)} s` })),
        },
        {
            name: 'Lights',
            items: shot.lights.map(({ name, path, kind }) => ({ name, path, about: kind })),
        },
    ];
    return groups.filter((group) => group.items.length > 0);
}
