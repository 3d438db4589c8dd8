/// How the search panel, folds and marks of the editor look.
import { EditorView } from '@codemirror/view';

const kField = {
    height: '28px', padding: '0 8px', border: '1px solid var(--line-strong)',
    borderRadius: 'var(--radius)', backgroundColor: 'var(--surface)', color: 'var(--text)',
    fontFamily: 'var(--mono)', fontSize: 'var(--size-mono)', margin: '0',
};

const kButton = {
    height: '28px', padding: '0 10px', border: '1px solid var(--line-strong)',
    borderRadius: 'var(--radius)', backgroundImage: 'none', backgroundColor: 'transparent',
    color: 'var(--text-soft)', fontFamily: 'var(--font)', fontSize: 'var(--size-small)', margin: '0',
    cursor: 'pointer', textTransform: 'capitalize',
};

export const editorLook = EditorView.theme({
    '.cm-panels': { backgroundColor: 'var(--raised)', color: 'var(--text)', zIndex: '6' },
    '.cm-panels.cm-panels-bottom': { borderTop: '1px solid var(--line)' },
    '.cm-panels.cm-panels-top': { borderBottom: '1px solid var(--line)' },
    '.cm-panel.cm-dialog, .cm-panel.cm-gotoLine': {
        display: 'flex', alignItems: 'center', gap: '6px', padding: '8px 36px 8px 10px',
        fontFamily: 'var(--font)',
    },
    '.cm-panel .cm-textfield': kField,
    '.cm-panel .cm-button': kButton,
    '.cm-panel .cm-button:hover': { backgroundColor: 'var(--hover)', color: 'var(--text)' },
    '.cm-panel [name=close], .cm-panel .cm-dialog-close': {
        position: 'absolute', top: '10px', right: '8px', width: '24px', height: '24px', padding: '0',
        border: '0', background: 'none', color: 'var(--text-faint)', fontSize: '18px',
        lineHeight: '20px', borderRadius: 'var(--radius)', cursor: 'pointer',
    },
    '.cm-searchMatch': {
        backgroundColor: 'var(--warning-soft)', outline: '1px solid color-mix(in srgb, var(--warning), transparent 55%)',
        borderRadius: '2px',
    },
    '.cm-searchMatch-selected': { backgroundColor: 'color-mix(in srgb, var(--warning), transparent 55%)' },
    '.cm-selectionMatch': { backgroundColor: 'color-mix(in srgb, var(--accent), transparent 82%)' },
    '&.cm-focused .cm-matchingBracket': {
        backgroundColor: 'color-mix(in srgb, var(--accent), transparent 75%)', borderRadius: '2px',
    },
    '.cm-foldGutter .cm-gutterElement': {
        width: '14px', textAlign: 'center', cursor: 'pointer', color: 'var(--text-faint)',
        opacity: '0', transition: 'opacity 100ms',
    },
    '.cm-gutters:hover .cm-foldGutter .cm-gutterElement, .cm-foldGutter .cm-gutterElement:has(.folded)':
        { opacity: '1' },
    '.cm-foldPlaceholder': {
        margin: '0 4px', padding: '0 6px', border: '0', borderRadius: 'var(--radius-small)',
        backgroundColor: 'var(--hover)', color: 'var(--text-faint)',
    },
    '&.cm-alt .cm-content': { cursor: 'ew-resize' },
    '.cm-lint-marker': { width: '9px', height: '9px', marginTop: '5px' },
    '.cm-lint-marker-error': { content: '""', borderRadius: '50%', backgroundColor: 'var(--danger)' },
    '.cm-lint-marker-warning': { content: '""', borderRadius: '2px', backgroundColor: 'var(--warning)' },
    '.cm-lintRange-error': {
        backgroundImage: 'none', textDecoration: 'underline wavy var(--danger) 1px',
        textUnderlineOffset: '3px', textDecorationSkipInk: 'none',
    },
    '.cm-lintRange-warning': {
        backgroundImage: 'none', textDecoration: 'underline wavy var(--warning) 1px',
        textUnderlineOffset: '3px', textDecorationSkipInk: 'none',
    },
    '.cm-diagnostic': { maxWidth: '420px', borderLeft: '0', whiteSpace: 'normal' },
    '.cm-diagnosticAction': {
        marginLeft: '10px', padding: '2px 8px', border: '1px solid var(--line-strong)',
        borderRadius: 'var(--radius)', backgroundColor: 'transparent', color: 'var(--accent)',
        fontSize: 'var(--size-small)', cursor: 'pointer',
    },
    '.cm-diagnosticAction:hover': { backgroundColor: 'var(--hover)' },
});
