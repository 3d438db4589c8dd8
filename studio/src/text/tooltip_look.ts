/// How completion, tooltips and the search panel look in both themes.
import { EditorView } from '@codemirror/view';

const list = EditorView.theme({
    '.cm-tooltip.cm-tooltip-autocomplete': { borderRadius: '8px', overflow: 'visible', padding: '4px' },
    '.cm-tooltip.cm-tooltip-autocomplete > ul': {
        fontFamily: 'var(--font)', fontSize: 'var(--size)', maxHeight: '17.5em', minWidth: '260px',
        maxWidth: 'min(460px, 90vw)', scrollbarWidth: 'thin',
    },
    '.cm-tooltip.cm-tooltip-autocomplete > ul > li': {
        display: 'flex', alignItems: 'baseline', gap: '10px', padding: '3px 8px',
        borderRadius: 'var(--radius-small)', lineHeight: '1.45',
    },
    '.cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]': {
        backgroundColor: 'var(--accent-soft)', color: 'var(--text)',
    },
    '.cm-completionLabel': { fontFamily: 'var(--mono)', fontSize: 'var(--size-mono)', flex: 'none' },
    '.completion-key .cm-completionLabel': { color: 'var(--code-key)' },
    '.completion-word .cm-completionLabel, .completion-value .cm-completionLabel':
        { color: 'var(--code-value)' },
    '.completion-name .cm-completionLabel': { color: 'var(--ball)' },
    '.completion-snippet .cm-completionLabel':
        { fontFamily: 'var(--font)', fontSize: 'var(--size)', color: 'var(--text)' },
    '.cm-completionMatchedText': { textDecoration: 'none', fontWeight: '700' },
    '.cm-completionDetail': {
        flex: '1', margin: '0', minWidth: '0', textAlign: 'right', fontStyle: 'normal',
        fontSize: 'var(--size-small)', color: 'var(--text-faint)', overflow: 'hidden',
        textOverflow: 'ellipsis', whiteSpace: 'nowrap',
    },
    '.cm-tooltip.cm-completionInfo': {
        width: 'max-content', maxWidth: '320px', padding: '10px 12px', borderRadius: '8px',
        marginTop: '-1px', whiteSpace: 'normal',
    },
    '.cm-snippetField': { backgroundColor: 'var(--accent-soft)', borderRadius: '2px' },
});

/// What is said about a key or value, in completion and on hovering.
const about = EditorView.theme({
    '.about': { fontFamily: 'var(--font)', fontSize: 'var(--size)', lineHeight: '1.45' },
    '.about .prose': { margin: '0 0 6px', color: 'var(--text)' },
    '.about .prose:last-child': { margin: '0' },
    '.about code': {
        fontFamily: 'var(--mono)', fontSize: '0.93em', padding: '0 3px',
        borderRadius: 'var(--radius-small)', backgroundColor: 'var(--hover)',
    },
    '.about pre': {
        margin: '6px 0 0', fontFamily: 'var(--mono)', fontSize: 'var(--size-small)',
        whiteSpace: 'pre-wrap', color: 'var(--text-soft)',
    },
    '.about .fact': { display: 'flex', gap: '10px', fontSize: 'var(--size-small)', marginTop: '2px' },
    '.about .fact .name': { flex: 'none', width: '58px', color: 'var(--text-faint)' },
    '.about .fact .value': { color: 'var(--text-soft)', overflowWrap: 'anywhere' },
    '.about .title': {
        display: 'flex', alignItems: 'baseline', marginBottom: '4px',
        fontFamily: 'var(--mono)', fontSize: 'var(--size-mono)', color: 'var(--code-key)',
    },
    '.about .title .above': { color: 'var(--text-faint)', whiteSpace: 'pre' },
    '.about .title .kind': {
        marginLeft: 'auto', paddingLeft: '16px', fontFamily: 'var(--font)', fontSize: 'var(--size-small)',
        color: 'var(--text-faint)', whiteSpace: 'nowrap',
    },
    '.cm-tooltip.cm-tooltip-hover': { borderRadius: '8px', zIndex: '20' },
    '.cm-tooltip-section + .cm-tooltip-section, .cm-tooltip-section:not(:first-child)':
        { borderTop: '1px solid var(--line)' },
    '.hover-about': { maxWidth: '360px', padding: '10px 12px' },
});

export const tooltipLook = [list, about];
