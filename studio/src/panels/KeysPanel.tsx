import { useEffect, useRef } from 'preact/hooks';
import { kKeyBindings, type KeyBinding } from '../state/keys';
import { panel } from '../state/state';
import './keys_panel.css';

const kGroups: KeyBinding['group'][] = ['Time', 'View', 'Selection', 'Text', 'Page'];
/// Commands that something answers; the others are not shown.
const kShown = new Set(['play', 'returnToStart', 'toStart', 'toEnd', 'frameBack', 'frameForward',
    'tenBack', 'tenForward', 'tenthBack', 'tenthForward', 'eventBack', 'eventForward', 'loop',
    'slower', 'faster', 'fitStrip', 'lookThrough', 'refine', 'viewTop', 'viewSide', 'viewFree', 'cancel',
    'save', 'undo', 'redo', 'keys']);

/// All keys of the page, as a dialog over it.
export function KeysPanel() {
    const dialog = useRef<HTMLDialogElement>(null);
    useEffect(() => dialog.current?.showModal(), []);
    const bindings: readonly KeyBinding[] = kKeyBindings;
    return (
        <dialog class="keys" ref={dialog} aria-label="Keys" onClose={() => { panel.value = null; }}>
            <div class="groups">
                {kGroups.map((group) => (
                    <section key={group}>
                        <h2>{group}</h2>
                        {bindings.filter((one) => one.group === group && kShown.has(one.command))
                            .map((one) => (
                                <p key={one.command}>
                                    <kbd>{one.keys[0]}</kbd> {one.about}
                                </p>
                            ))}
                    </section>
                ))}
            </div>
            <button type="button" class="tool" onClick={() => dialog.current?.close()}>Close</button>
        </dialog>
    );
}
