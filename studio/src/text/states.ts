/// States of the editor: new ones, and those that a page left behind.
import { history, historyField } from '@codemirror/commands';
import { Annotation, EditorState, type Extension } from '@codemirror/state';

let extensions: (writable: boolean) => Extension = () => [];

/// The extensions that every text has beside its history.
export function setExtensions(make: (writable: boolean) => Extension): void {
    extensions = make;
}

/// CRLF is kept if the whole file has it; a mixed file keeps its carriage returns as characters.
export function lineBreak(text: string): string {
    return /\r\n/.test(text) && !/(^|[^\r])\n/.test(text) ? '\r\n' : '\n';
}

/// Says that a change soon after the last event of its history becomes one with that.
export const joinsLast = Annotation.define<boolean>();

/// Changes within this time may become one step: on a slow machine, those of a drag in another window
/// arrive some hundred milliseconds apart.
const kOneStep = 1000;  // ms

/// A history that forgets steps by itself would no longer fit the steps over all files.
const kUnlimited = 1e9;

function extensionsOf(text: string, writable: boolean): Extension {
    return [
        EditorState.lineSeparator.of(lineBreak(text)),
        EditorState.readOnly.of(!writable),
        history({ minDepth: kUnlimited, newGroupDelay: kOneStep,
            joinToEvent: (transaction, isAdjacent) =>
                isAdjacent || transaction.annotation(joinsLast) === true }),
        extensions(writable),
    ];
}

export function makeState(text: string, writable: boolean): EditorState {
    return EditorState.create({ doc: text, extensions: extensionsOf(text, writable) });
}

const kFields = { history: historyField };

/// A state with its history as data.
export function stateToJson(state: EditorState): unknown {
    return state.toJSON(kFields);
}

/// The state of such data; null if it is none.
export function stateFromJson(json: unknown, writable: boolean): EditorState | null {
    try {
        const text = (json as { doc: string }).doc;
        return EditorState.fromJSON(json, { extensions: extensionsOf(text, writable) }, kFields);
    } catch {
        return null;
    }
}
