/// Two texts beside each other with their differences marked.
import { MergeView } from '@codemirror/merge';
import { yaml } from '@codemirror/lang-yaml';
import { defaultKeymap, history, historyKeymap } from '@codemirror/commands';
import { EditorState, type Extension } from '@codemirror/state';
import { EditorView, keymap, lineNumbers } from '@codemirror/view';
import { useEffect, useRef } from 'preact/hooks';
import { pageNonce } from '../text/nonce';
import { yamlLook } from '../text/highlight';
import './merge_panel.css';

interface Properties {
    left: string;
    right: string;
    leftTitle: string;
    rightTitle: string;
    /// Called whenever the right text was changed; without it, both can only be read.
    onRight?: ((text: string) => void) | undefined;
}

function look(label: string): Extension {
    return [EditorView.cspNonce.of(pageNonce()), lineNumbers(), yaml(), yamlLook,
        EditorView.contentAttributes.of({ 'aria-label': label, tabindex: '0' })];
}

const kReadOnly: Extension = [EditorState.readOnly.of(true), EditorView.editable.of(false)];

/// An arrow that takes a difference over from the left.
function arrow(): HTMLElement {
    const button = document.createElement('button');
    button.type = 'button';
    button.className = 'take';
    button.textContent = '→';
    button.title = 'Take this over';
    button.setAttribute('aria-label', 'Take this difference over from the left');
    return button;
}

/// The left text can be read; differences are taken over to the right by arrows, and the right text
/// can be changed. Fills its parent.
export function MergePanel({ left, right, leftTitle, rightTitle, onRight }: Properties) {
    const parent = useRef<HTMLDivElement>(null);
    useEffect(() => {
        if (!parent.current) {
            return undefined;
        }
        const onChange = EditorView.updateListener.of((update) => {
            if (update.docChanged) {
                onRight?.(update.state.doc.toString());
            }
        });
        const own: Extension = onRight
            ? [history(), keymap.of([...historyKeymap, ...defaultKeymap]), onChange] : kReadOnly;
        const view = new MergeView({
            parent: parent.current,
            a: { doc: left, extensions: [look(leftTitle), kReadOnly] },
            b: { doc: right, extensions: [look(rightTitle), own] },
            ...onRight ? { revertControls: 'a-to-b' as const, renderRevertControl: arrow } : {},
            collapseUnchanged: { margin: 3, minSize: 6 },
            gutter: true,
        });
        view.dom.querySelector('.cm-changedLine')?.scrollIntoView({ block: 'center' });
        return () => view.destroy();
    }, [left, right]);
    return (
        <div class="merge">
            <div class="merge-titles"><span>{leftTitle}</span><span>{rightTitle}</span></div>
            <div class="merge-texts" ref={parent} />
        </div>
    );
}
