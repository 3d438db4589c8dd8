import { useEffect, useRef } from 'preact/hooks';
import { isBound, keyWords, kKeyBindings, type Command, type KeyBinding } from '../state/keys';
import { panel } from '../state/state';
import './keys_panel.css';

const kGroups: KeyBinding['group'][] = ['Time', 'View', 'Selection', 'Text', 'Page'];

/// Keys that belong to the place that has the focus, or to the pointer.
const kFurther: Readonly<Record<KeyBinding['group'], readonly (readonly [string, string])[]>> = {
    Time: [['pageup', 'On a handle of the strip: the handle before'],
        ['pagedown', 'On a handle of the strip: the next handle'],
        ['arrows', 'On a handle of the strip: move it by a frame, with Shift by ten']],
    View: [],
    Selection: [['arrows', 'Move the selected ball or object by 1 mm, with Alt by 0.1 mm, with Shift by 10 mm'],
        ['arrows', 'While strikes that pot a ball are shown: go through them; with Shift, move the place where the struck ball ends'],
        ['enter', 'While they are shown: write the chosen one'],
        ['escape', 'While they are shown: leave them'],
        ['x y z', 'While dragging: move along this axis only']],
    Text: [['ctrl+space', 'Complete'], ['ctrl+f', 'Find and replace']],
    Page: [],
};

function Keys({ keys }: { keys: readonly string[] }) {
    return (
        <span class="keys">
            {keys.slice(0, 2).map((key, i) => (
                <span key={key}>
                    {i > 0 ? <i>or</i> : null}
                    {(key === 'x y z' ? key.split(' ') : keyWords(key)).map((one) =>
                        <kbd key={one}>{one}</kbd>)}
                </span>
            ))}
        </span>
    );
}

/// All keys of the page, as a dialog over it.
export function KeysPanel() {
    const dialog = useRef<HTMLDialogElement>(null);
    useEffect(() => dialog.current?.showModal(), []);
    const bindings: readonly KeyBinding[] = kKeyBindings;
    return (
        <dialog class="keys-page" ref={dialog} aria-label="Keys" onClose={() => { panel.value = null; }}
            onClick={(event) => { if (event.target === dialog.current) { dialog.current?.close(); } }}>
            <header><h1>Keys</h1>
                <button type="button" class="tool" onClick={() => dialog.current?.close()}>Close</button>
            </header>
            <div class="groups" tabIndex={0} role="region" aria-label="All keys">
                {kGroups.map((group) => (
                    <section key={group}>
                        <h2>{group}</h2>
                        {bindings.filter((one) => one.group === group && one.keys.length > 0
                            && isBound(one.command as Command))
                            .map((one) => <p key={one.command}><Keys keys={one.keys} />{one.about}</p>)}
                        {kFurther[group].map(([key, about]) => (
                            <p key={`${key} ${about}`}><Keys keys={[key]} />{about}</p>
                        ))}
                    </section>
                ))}
            </div>
        </dialog>
    );
}
