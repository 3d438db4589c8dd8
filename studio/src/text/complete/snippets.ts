/// Whole entries of lists and maps. ${...} are places to fill in, in their order.
import type { KeyPath, Names } from '../../protocol';
import { fractionOf, sum, timeText } from '../../strip/film_time';

export interface Snippet {
    label: string;
    about: string;
    /// With an indent of 0; the first line begins the entry, without the dash of a list.
    yaml: string;
}

function ball(names: Names): string {
    return names.balls.includes('cue') ? 'cue' : names.balls[0] ?? 'cue';
}

function events(names: Names): Snippet[] {
    const cue = ball(names);
    const other = names.balls.find((one) => one !== cue) ?? names.objects[0] ?? 'one';
    return [
        { label: 'strike', about: 'A strike with the cue stick towards a ball.',
            yaml: `strike: {ball: \${${cue}}, at: \${0.5 s}, toward: \${${other}}, speed: \${3 m/s}, `
                + 'tip: [${0}, ${0}]}' },
        { label: 'strike by a direction', about: 'A strike along a direction over the cloth.',
            yaml: `strike: {ball: \${${cue}}, at: \${0.5 s}, direction: \${0 deg}, speed: \${3 m/s}}` },
        { label: 'force', about: 'A force that acts on a body for some time.',
            yaml: `force: {object: \${${cue}}, at: \${1 s}, for: \${0.5 s}, `
                + 'newtons: [${0}, ${0.1}, ${0}]}' },
        { label: 'impulse at a contact', about: 'An impulse when two bodies touch.',
            yaml: `impulse:\n  object: \${${cue}}\n  when: {contact: [\${${cue}}, \${${other}}]}\n`
                + '  newton_seconds: [${0}, ${0}, ${0.2}]' },
        { label: 'place a ball', about: 'A ball is put down at rest, when everything rests.',
            yaml: `place: {ball: \${${other}}, spot: [\${0}, \${0.3}], when: {resting: all}}` },
        { label: 'velocity', about: 'A change of velocity at a time.',
            yaml: `velocity: {object: \${${cue}}, at: \${1 s}, linear: [\${0}, \${0}, \${1}]}` },
    ];
}

function cameras(names: Names, filmEnd: number): Snippet[] {
    const from = fractionOf(filmEnd);
    const start = timeText(from, null);
    const end = timeText(sum(from, { numerator: 3, denominator: 1 }), null);
    const times = `video: [\${${start}}, \${${end}}]\nscene: [\${0 s}, \${3 s}]\n`;
    const cue = ball(names);
    return [
        { label: 'camera that stands still', about: 'Looks at one point from one place.',
            yaml: `name: \${still}\n${times}position: [\${-0.4}, \${-1.6}, \${0.9}]\n`
                + 'target: [${0}, ${0}, ${0.03}]\nfov: ${40 deg}' },
        { label: 'camera that moves', about: 'Flies along a curve with control points.',
            yaml: `name: \${moving}\n${times}position:\n  bezier:\n    - [\${-1.2}, \${-0.5}, \${0.3}]\n`
                + '    - [${0}, ${-0.8}, ${0.4}]\n    - [${0.6}, ${-0.4}, ${0.2}]\n'
                + 'target: [${0.5}, ${0}, ${0.03}]\nfov: ${40 deg}' },
        { label: 'camera that follows a ball', about: 'Stands still and turns with a ball.',
            yaml: `name: \${follow}\n${times}position: [\${-0.4}, \${-1.6}, \${0.9}]\n`
                + `target: {follow: \${${cue}}}\nfov: \${30 deg}` },
        { label: 'camera of a rig', about: 'A ready camera from a file.',
            yaml: `include: \${rigs/orbit.yaml}\nname: \${orbit}\n${times.trim()}` },
    ];
}

function lights(): Snippet[] {
    return [
        { label: 'rectangular lamp', about: 'A lamp with soft shadows.',
            yaml: '${lamp}: {rectangle: [${0.6}, ${0.3}], at: [${0}, ${0}, ${1.6}], '
                + 'facing: [${0}, ${0}, ${-1}], radiance: ${20}}' },
        { label: 'lamp in a shade', about: 'A lamp as it hangs over a table.',
            yaml: '${lamp}: {shade: {radius: ${20 cm}, height: ${22 cm}}, at: [${0}, ${0}, ${1.05}], '
                + 'lumens: ${2500}}' },
        { label: 'point light', about: 'A light without a surface: hard shadows.',
            yaml: '${point}: {point: ${20}, at: [${0}, ${0}, ${1.8}]}' },
        { label: 'spot light', about: 'A point light within a cone.',
            yaml: '${spot}: {spot: ${40}, at: [${0}, ${0}, ${2}], facing: [${0}, ${0}, ${-1}], '
                + 'angle: ${30 deg}}' },
    ];
}

function objects(): Snippet[] {
    return [
        { label: 'box', about: 'A box that the simulation moves.',
            yaml: '${box}: {box: [${0.1}, ${0.1}, ${0.1}], at: [${0.3}, ${0.3}, ${0.05}], '
                + 'physics: {density: ${700 kg/m^3}}}' },
        { label: 'sphere', about: 'A sphere that is only visible.',
            yaml: '${sphere}: {sphere: ${0.05}, at: [${0.3}, ${0.3}, ${0.05}]}' },
        { label: 'cylinder', about: 'A cylinder that the simulation moves.',
            yaml: '${cylinder}: {cylinder: {radius: ${0.03}, height: ${0.1}}, '
                + 'at: [${0.3}, ${0.3}, ${0.05}], physics: {density: ${700 kg/m^3}}}' },
    ];
}

function materials(): Snippet[] {
    return [
        { label: 'matte material', about: 'A colour without gloss.',
            yaml: '${paint}: {standard: {base: [${0.6}, ${0.1}, ${0.08}], roughness: ${0.9}}}' },
        { label: 'metal', about: 'A polished metal.',
            yaml: '${brass}: {standard: {base: [${0.78}, ${0.56}, ${0.26}], metal: 1, '
                + 'roughness: ${0.2}}}' },
        { label: 'glass', about: 'Clear glass.',
            yaml: '${glass}: {standard: {base: [1, 1, 1], transmission: 1, ior: ${1.5}, '
                + 'roughness: ${0}}}' },
    ];
}

function annotations(names: Names): Snippet[] {
    const cue = ball(names);
    const other = names.balls.find((one) => one !== cue);
    const pairs: Snippet[] = other === undefined ? [] : [
        { label: 'ghost ball', about: 'Where a ball is when it touches another one.',
            yaml: `ghost: {of: \${${cue}}, on: \${${other}}}` },
        { label: 'tangent line', about: 'The line at right angles to a contact.',
            yaml: `tangent: {of: \${${cue}}, on: \${${other}}}` },
        { label: 'angle of a contact', about: 'By how much a contact turns the way of a ball.',
            yaml: `angle: {deflection: [\${${cue}}, \${${other}}]}` },
    ];
    return [
        { label: 'path of a ball', about: 'The way of a ball, with dots at equal times.',
            yaml: `path: {of: \${${cue}}, marks: \${0.1 s}}` },
        { label: 'aim line', about: 'The line along which a ball is aimed.',
            yaml: other === undefined ? `aim: {of: \${${cue}}, direction: \${0 deg}}`
                : `aim: {of: \${${cue}}, toward: \${${other}}}` },
        ...pairs,
        { label: 'arrow of speed', about: 'An arrow along the velocity of a ball, with its speed.',
            yaml: `velocity: {of: \${${cue}}, value: \${true}}` },
        { label: 'arrow of spin', about: 'A round arrow about the axis of the spin.',
            yaml: `spin: {of: \${${cue}}}` },
        { label: 'zone on the cloth', about: 'A circle on the cloth.',
            yaml: 'zone: {radius: ${0.15}, at: [${0}, ${0}]}' },
        { label: 'label of a ball', about: 'A text that follows a ball.',
            yaml: `label: {of: \${${cue}}, text: "{${cue}.speed:.1f} m/s"}` },
        { label: 'text', about: 'Lines of text on the picture.',
            yaml: `{text: "\${Text}", position: \${bottom}}` },
        { label: 'title', about: 'Large text with a smaller line.',
            yaml: 'title: {text: "${Title}", subtitle: "${a smaller line}"}' },
        { label: 'tip diagram', about: 'Where the stick hits a ball.',
            yaml: `{tip: {of: \${${cue}}}, position: \${bottom_right}}` },
        { label: 'plan of the table', about: 'The table from above, as a small picture.',
            yaml: '{plan: {}, position: ${top_right}}' },
    ];
}

/// Whole entries for the list or map at `path`.
export function snippetsFor(path: KeyPath, names: Names, filmEnd: number): Snippet[] {
    const [section] = path;
    if (path.length !== 1) {
        return [];
    }
    switch (section) {
        case 'events':
            return events(names);
        case 'cameras':
            return cameras(names, filmEnd);
        case 'annotations':
            return annotations(names);
        case 'lights':
            return lights();
        case 'objects':
            return objects();
        case 'materials':
            return materials();
        case 'balls':
            return [{ label: 'ball', about: 'A ball on the cloth.',
                yaml: '${ball}: {at: [${0}, ${0}]}' }];
        default:
            return [];
    }
}
