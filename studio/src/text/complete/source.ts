/// Completion in the text: keys, values, names, units and whole entries.
import {
    acceptCompletion, autocompletion, snippet, startCompletion,
    type Completion, type CompletionContext, type CompletionResult,
} from '@codemirror/autocomplete';
import { Prec, type Extension } from '@codemirror/state';
import { keymap, type EditorView } from '@codemirror/view';
import { schema } from '../../schema/schema';
import { shot } from '../../state/state';
import { spotAt, type Spot } from '../spot';
import {
    keyCandidates, kNoNames, snippetCandidates, unitsAt, valueCandidates,
    type Candidate, type Known,
} from './candidates';
import { configFiles } from './config_files';
import { aboutCandidate } from './about';

/// What is known of the shot now; null before the schema has come.
export function known(): Known | null {
    const names = shot.value?.names ?? kNoNames;
    const files = configFiles.value;
    return schema.value && {
        schema: schema.value, names,
        includes: files,
        presets: files.flatMap(({ name }) => /^quality\/(.*)\.yaml$/.exec(name)?.[1] ?? []),
        filmEnd: shot.value?.film.duration ?? 0,
    };
}

type Apply = (view: EditorView, completion: Completion, from: number, to: number) => void;

/// Writes a key with its colon, unless it has one, and offers its values.
const applyKey: Apply = (view, completion, from, to) => {
    const rest = view.state.sliceDoc(to, Math.min(view.state.doc.length, to + 80));
    const word = /^[\w-]*/.exec(rest)?.[0].length ?? 0;
    const hasColon = /^[\w-]*[ \t]*:/.test(rest);
    const insert = hasColon ? completion.label : `${completion.label}: `;
    view.dispatch({
        changes: { from, to: to + word, insert },
        selection: { anchor: from + insert.length }, userEvent: 'input.complete',
    });
    if (!hasColon) {
        startCompletion(view);
    }
};

/// Each place to fill in with a number of its own, so that equal words are not one place.
function numbered(template: string): string {
    let count = 0;
    return template.replace(/\$\{([^}]*)\}/g, (_, word: string) => {
        count += 1;
        return `\${${count}:${word}}`;
    });
}

/// Writes text with places to fill in; further lines are indented as the first.
function applySnippet(yaml: string, before: string, column: number): Apply {
    return (view, completion, from, to) => {
        // CodeMirror indents further lines as the line at `from` is.
        const line = view.state.doc.lineAt(from).text;
        const own = line.length - line.trimStart().length;
        const more = ' '.repeat(Math.max(0, column + before.length - own));
        const text = numbered((before + yaml).replace(/\n/g, `\n${more}`));
        snippet(text)(view, completion, from, to);
    };
}

function option(candidate: Candidate, rank: number, one: Partial<Completion>): Completion {
    const { label, kind, detail } = candidate;
    return {
        label, detail, type: kind, sortText: String(rank).padStart(4, '0'),
        info: () => aboutCandidate(candidate), ...one,
    };
}

function keyOptions(all: Known, spot: Spot, path = spot.path): Completion[] {
    return keyCandidates(all, path, spot.present)
        .map((one, i) => option(one, 1000 + i, { apply: applyKey, boost: 1 }));
}

/// Whole entries: after a dash, in place of a key, or with a dash of their own.
function snippetOptions(all: Known, spot: Spot): Completion[] {
    if (spot.isFlow || spot.kind === 'value') {
        return [];
    }
    const isItem = spot.kind === 'either' && /^\d+$/.test(spot.path[spot.path.length - 1] ?? '');
    const path = isItem ? spot.path.slice(0, -1) : spot.path;
    const isList = ['events', 'cameras', 'annotations'].includes(path[0] ?? '');
    const dash = isList && !isItem ? '- ' : '';
    return snippetCandidates(all, path).map((one, i) => option(one, i, {
        boost: 2, apply: applySnippet(one.insert ?? one.label, dash, spot.column),
    }));
}

function valueOptions(all: Known, spot: Spot): Completion[] {
    const isBlock = spot.kind === 'either';
    return valueCandidates(all, spot.path).filter(({ kind }) => !isBlock || kind !== 'value')
        .map((one, i) => option(one, 2000 + i, one.insert === undefined ? {}
            : { apply: (view, completion, from, to) => {
                snippet(numbered(one.insert ?? ''))(view, completion, from, to);
                startCompletion(view);
            } }));
}

const kNumber = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?:\s*\/\s*\d+)?(\s*)([A-Za-z/^0-9]*)$/;

/// The units after a number.
function unitResult(all: Known, spot: Spot, typed: string, at: number): CompletionResult | null {
    const number = kNumber.exec(typed);
    if (!number) {
        return null;
    }
    const [, space = '', unit = ''] = number;
    const options = unitsAt(all, spot.path).map((label, i): Completion => ({
        label, type: 'unit', sortText: String(i), detail: i === 0 ? 'unit' : '',
        apply: space === '' ? ` ${label}` : label,
    }));
    return options.length > 0 ? { from: at - unit.length, options, validFor: /^[A-Za-z/^0-9]*$/ }
        : null;
}

const kWord = /^[\w./-]*$/;

/// What can be written at the cursor.
export function complete(context: CompletionContext): CompletionResult | null {
    const all = known();
    const text = context.state.doc.toString();
    const spot = all && spotAt(text, context.pos);
    if (!all || !spot) {
        return null;
    }
    const typed = text.slice(spot.from, context.pos);
    const isQuiet = !context.explicit && typed === '' && spot.kind !== 'value';
    if (isQuiet) {
        return null;
    }
    if (spot.kind !== 'key') {
        const units = unitResult(all, spot, typed, context.pos);
        if (units || /^[-+\d]/.test(typed)) {
            return units;
        }
    }
    const options = [
        ...snippetOptions(all, spot),
        ...spot.kind === 'value' ? [] : keyOptions(all, spot),
        ...spot.kind === 'key' ? [] : valueOptions(all, spot),
    ];
    return options.length > 0 ? { from: spot.from, options, validFor: kWord } : null;
}

/// Completion with its keys: Enter and Tab take what is marked, Ctrl-Space asks.
export function completion(): Extension {
    return [
        autocompletion({
            override: [complete], icons: false, activateOnTyping: true, maxRenderedOptions: 200,
            optionClass: ({ type }) => `completion-${type ?? 'value'}`,
        }),
        Prec.highest(keymap.of([{ key: 'Tab', run: acceptCompletion }])),
    ];
}

/// The labels that are offered at an offset of a text, for tests.
export function labelsAt(text: string, offset: number): string[] {
    const all = known();
    const spot = all && spotAt(text, offset);
    if (!all || !spot) {
        return [];
    }
    const keys = spot.kind === 'value' ? [] : keyCandidates(all, spot.path, spot.present);
    const values = spot.kind === 'key' ? [] : valueCandidates(all, spot.path);
    return [...keys, ...values].map(({ label }) => label);
}
