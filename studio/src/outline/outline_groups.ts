/// The tree of what a shot has, for the outline.
import type { KeyPath, SequenceState, ShotState } from '../protocol';
import { annotationName, withoutValues } from './annotation_name';

export interface OutlineItem {
    name: string;
    about: string;
    path: KeyPath;
    /// What its symbol shows: the kind of event, of light, a ball's colour.
    kind: string;
}

export interface OutlineGroup {
    name: string;
    /// The section of the shot that new entries go to; empty: nothing can be added.
    section: string;
    items: OutlineItem[];
}

/// Sections of a shot that are one thing each.
const kSettings: readonly { section: string; name: string }[] = [
    { section: 'render', name: 'Film and picture' }, { section: 'output', name: 'Output' },
    { section: 'sound', name: 'Sound' }, { section: 'simulation', name: 'Simulation' },
    { section: 'table', name: 'Table' }, { section: 'rack', name: 'Rack' },
    { section: 'conditions', name: 'Conditions' }, { section: 'physics', name: 'Physics' },
];

/// The groups of a shot, in the order in which one works: what moves, what happens, who looks.
export function outlineGroups(shot: ShotState): OutlineGroup[] {
    const things = (kind: string) => shot.objects.filter((object) => object.kind === kind)
        .map(({ name, path, shape }) =>
            ({ name, path, about: kind === 'ball' ? '' : shape, kind: kind === 'ball' ? 'ball' : shape }));
    return [
        { name: 'Balls', section: 'balls', items: things('ball') },
        { name: 'Events', section: 'events', items: shot.events.map(({ kind, object, path, time }) =>
            ({ name: `${kind} ${object}`, path, kind, about: `${time.toFixed(2)} s` })) },
        { name: 'Cameras', section: 'cameras', items: shot.cameras.map(
            ({ name, path, video_start, video_end }) => ({ name, path, kind: 'camera',
                about: `${(video_end - video_start).toFixed(2)} s` })) },
        { name: 'Annotations', section: 'annotations', items: shot.annotations.map((one) =>
            ({ name: annotationName(one), path: one.path, kind: one.kind,
                about: withoutValues(one.text).replace(/\s+/g, ' ').trim() })) },
        { name: 'Objects', section: 'objects', items: things('object') },
        { name: 'Lights', section: 'lights', items: shot.lights.map(({ name, path, kind }) =>
            ({ name, path, about: kind, kind })) },
        { name: 'Materials', section: 'materials', items: shot.names.materials.map((name) =>
            ({ name, path: ['materials', name], about: '', kind: 'material' })) },
        { name: 'Settings', section: '', items: kSettings.map(({ section, name }) =>
            ({ name, path: [section], about: '', kind: 'setting' })) },
    ];
}

/// The groups of a film of several shots.
export function groupsOfSequence({ film, parts }: SequenceState): OutlineGroup[] {
    return [
        { name: 'Parts', section: 'film.shots', items: parts.map(({ name, path, kind, frames }) =>
            ({ name: name.replace(/\s+/g, ' '), path, kind: kind === 'title' ? 'title' : 'camera',
                about: `${(frames / film.fps).toFixed(2)} s` })) },
        { name: 'Settings', section: '', items: [
            { name: 'Size and rate', path: ['film'], about: '', kind: 'setting' },
            { name: 'Output', path: ['output'], about: '', kind: 'setting' }] },
    ];
}

/// The groups with the items whose name, kind or group contains a word; groups without any are left
/// out.
export function matchingGroups(groups: readonly OutlineGroup[], word: string): OutlineGroup[] {
    const needle = word.trim().toLowerCase();
    return needle === '' ? [...groups] : groups
        .map((group) => ({ ...group, items: group.items.filter((item) =>
            [item.name, item.kind, group.name].some((text) => text.toLowerCase().includes(needle))) }))
        .filter((group) => group.items.length > 0);
}

/// The name of the thing at a path: "cue", "camera slow", "strike cue".
export function titleOf(path: KeyPath, groups: readonly OutlineGroup[]): string {
    const key = path.join('/');
    for (const group of groups) {
        const item = group.items.find((one) => one.path.join('/') === key);
        if (item) {
            return ['Events', 'Settings'].includes(group.name)
                ? item.name : `${group.name.toLowerCase().replace(/s$/, '')} ${item.name}`;
        }
    }
    return path.join(' › ');
}
