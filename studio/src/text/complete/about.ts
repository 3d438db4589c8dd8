/// What is shown beside a marked candidate.
import { typesOf } from '../../schema/value_types';
import { schema } from '../../schema/schema';
import type { Candidate } from './candidates';

/// An element with a class and a text, and further elements.
export function make(
    tag: string, name: string, text: string, ...children: (HTMLElement | null)[]
): HTMLElement {
    const element = document.createElement(tag);
    element.className = name;
    element.textContent = text;
    element.append(...children.filter((child) => child !== null));
    return element;
}

/// A row "name value" of a tooltip; null without a value.
export function fact(name: string, value: string): HTMLElement | null {
    return value === '' ? null
        : make('div', 'fact', '', make('span', 'name', name), make('span', 'value', value));
}

/// Carom's descriptions with `words` as code.
export function prose(text: string): HTMLElement {
    const element = make('p', 'prose', '');
    for (const [i, part] of text.split('`').entries()) {
        element.append(i % 2 === 1 ? make('code', '', part) : document.createTextNode(part));
    }
    return element;
}

/// A sentence, the range and the default; null if nothing is known.
export function aboutCandidate({ about, key, kind, insert }: Candidate): HTMLElement | null {
    const all = schema.value;
    const types = all && key ? typesOf(all, key.node) : [];
    const range = types.flatMap((type) => type.kind === 'number' && type.range !== ''
        ? [type.range] : [])[0] ?? '';
    const words = types.flatMap((type) =>
        type.kind === 'choice' || type.kind === 'text' ? type.words : []).join(', ');
    const parts = [fact('range', range), fact('one of', words), fact('default', key?.usual ?? '')];
    const preview = kind === 'snippet'
        ? make('pre', '', (insert ?? '').replace(/\$\{([^}]*)\}/g, '$1')) : null;
    return about === '' && !preview && parts.every((part) => part === null) ? null
        : make('div', 'about', '', about === '' ? null : prose(about), ...parts, preview);
}
