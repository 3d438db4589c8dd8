/// What can be written, and in which formats.
import type { DocumentKind } from './documents_state';

export const kTitles: Readonly<Record<DocumentKind, string>> = {
    plan: 'Plan', report: 'Report', plot: 'Speeds and energy', contact_sheet: 'Contact sheet',
    export: 'Export',
};

export interface Format {
    what: string;  // as Make says it
    label: string;
    about: string;
    endings: readonly string[];
    suffix: string;  // of the suggested name
    hasRate?: boolean;
}

const kPictures = ['.png', '.jpg', '.bmp', '.tga'];

export const kFormats: Readonly<Record<DocumentKind, readonly Format[]>> = {
    plan: [{ what: 'plan', label: 'Plan', suffix: '_plan', endings: ['.svg', '.png'],
        about: 'The table to scale, from above.' }],
    report: [{ what: 'report', label: 'Report', suffix: '_report', endings: ['.txt', '.json'],
        about: 'As tables, or as .json with full precision.' }],
    plot: [{ what: 'plot', label: 'Plot', suffix: '_plot', endings: ['.svg', '.png'],
        about: 'Speeds and energy over time.' }],
    contact_sheet: [{ what: 'contact_sheet', label: 'Contact sheet', suffix: '_sheet',
        endings: kPictures, about: 'Frames of the film at equal intervals.' }],
    export: [
        { what: 'export', label: 'Motion as a table', suffix: '', endings: ['.csv'], hasRate: true,
            about: 'A row for each object and time: for Python, R or a spreadsheet.' },
        { what: 'export', label: 'Motion and scene as JSON', suffix: '', endings: ['.json'],
            hasRate: true, about: 'Tracks, objects, events and cameras: for your own programs.' },
        { what: 'export', label: 'Scene as glTF', suffix: '', endings: ['.glb'],
            about: 'Shapes, materials, cameras and motion: for Blender and viewers on the web.' },
        { what: 'export', label: 'Scene as USD', suffix: '', endings: ['.usda'],
            about: 'The same as USD: for Houdini, Omniverse and Blender.' },
        { what: 'events', label: 'Events as a table', suffix: '_events', endings: ['.csv'],
            about: 'Strikes, impacts and potted balls, with times, speeds and spins.' },
        { what: 'frame', label: 'The frame at the play head', suffix: '_frame',
            endings: [...kPictures, '.exr'],
            about: 'As carom frame renders it; .exr keeps the full range of light.' },
    ],
};

/// What can be written of a film of several shots; the rest is that of one shot.
const kOfSequence: Readonly<Partial<Record<DocumentKind, readonly Format[]>>> = {
    contact_sheet: kFormats.contact_sheet,
    export: kFormats.export.filter(({ what }) => what === 'frame').map((format) =>
        ({ ...format, endings: kPictures, about: 'As carom frame renders it.' })),
};

export function formatsOf(kind: DocumentKind, isSequence: boolean): readonly Format[] {
    return isSequence ? kOfSequence[kind] ?? [] : kFormats[kind];
}

/// The name of a file with another ending.
export function withEnding(name: string, ending: string): string {
    return name.replace(/\.[A-Za-z0-9]{1,5}$/, '') + ending;
}

/// What is wrong with a file's name for a format, as a sentence; empty: nothing.
export function problemOfOutput(name: string, endings: readonly string[]): string {
    const found = /\.[^./]*$/.exec(name.trim())?.[0].toLowerCase() ?? '';
    return endings.includes(found) ? '' : `The name must end in ${listOf(endings)}.`;
}

function listOf(words: readonly string[]): string {
    return words.length < 2 ? words.join('')
        : `${words.slice(0, -1).join(', ')} or ${words[words.length - 1]}`;
}
