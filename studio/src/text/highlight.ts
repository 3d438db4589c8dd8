/// Colours of YAML in both themes, by the names of tokens.css.
import { HighlightStyle, syntaxHighlighting } from '@codemirror/language';
import { EditorView } from '@codemirror/view';
import { tags } from '@lezer/highlight';

const colours = HighlightStyle.define([
    { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: 'var(--code-key)' },
    { tag: [tags.content, tags.string], color: 'var(--code-value)' },
    { tag: tags.special(tags.string), color: 'var(--code-value)' },
    { tag: tags.comment, color: 'var(--text-faint)', fontStyle: 'italic' },
    { tag: [tags.labelName, tags.typeName], color: 'var(--code-anchor)' },
    { tag: [tags.punctuation, tags.separator, tags.squareBracket, tags.brace],
        color: 'var(--text-faint)' },
]);

const look = EditorView.theme({
    '&': { height: '100%', backgroundColor: 'var(--surface)', color: 'var(--text)' },
    '.cm-scroller': { fontFamily: 'var(--mono)', fontSize: 'var(--size-mono)', lineHeight: '1.55' },
    '.cm-content': { caretColor: 'var(--accent)' },
    '.cm-cursor': { borderLeftColor: 'var(--accent)', borderLeftWidth: '2px' },
    '.cm-gutters': {
        backgroundColor: 'var(--surface)', color: 'var(--text-faint)', border: 'none',
    },
    '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'var(--line-active)' },
    '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground':
        { backgroundColor: 'var(--accent-soft)' },
    '.cm-tooltip': {
        backgroundColor: 'var(--raised)', color: 'var(--text)', boxShadow: 'var(--shadow)',
        border: '1px solid var(--line-strong)', borderRadius: 'var(--radius)',
    },
    '.cm-panels': { backgroundColor: 'var(--raised)', color: 'var(--text)' },
    '.cm-diagnostic': { padding: '6px 10px', fontFamily: 'var(--font)' },
});

export const yamlLook = [syntaxHighlighting(colours), look];
