/// Every command of the page, every thing of the shot, and all that can be added, found by words.
import { signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { templatesOf } from '../outline/commands';
import { groupsNow } from '../outline/groups_now';
import { isBound, keyWords, kKeyBindings, runCommand, type KeyBinding } from '../state/keys';
import { fileItems } from '../start/FileMenu';
import { lookThrough, panel, selection, shot } from '../state/state';
import './palette.css';

export interface Entry {
    text: string;
    group: string;
    key: string; // as the table of keys writes it, or empty
    run(): void;
}

const kMost = 60; // entries that are shown
const word = signal('');
const at = signal(0);

/// All that can be chosen now.
function allEntries(): Entry[] {
    const bindings: readonly KeyBinding[] = kKeyBindings;
    const commands = bindings
        .filter((one) => one.command !== 'palette' && isBound(one.command as never))
        .map((one): Entry => ({ text: one.about, group: one.group, key: one.keys[0] ?? '',
            run: () => { runCommand(one.command as never); } }));
    const groups = groupsNow.value;
    const cameras = (shot.value?.cameras ?? []).map(({ name }): Entry => ({ key: '', group: 'View',
        text: `Look through camera ${name}`, run: () => { lookThrough.value = name; } }));
    const adds = groups.filter(({ section }) => section !== '').flatMap(({ section }) =>
        templatesOf(section).map(({ label, run }): Entry =>
            ({ text: `Add ${label}`, group: 'Add', key: '', run })));
    const things = groups.flatMap((group) => group.items.map((item): Entry => ({ key: '',
        text: `Select ${item.name}`, group: group.name, run: () => { selection.value = item.path; } })));
    const files = fileItems().filter(({ hint = '', isDisabled }) => !isDisabled && !hint.startsWith('Ctrl+'))
        .map(({ label, run }): Entry => ({ text: label, group: 'File', key: '', run }));
    return [...commands, ...files, ...cameras, ...adds, ...things];
}

/// The entries with all words of a text, those that begin with it first.
export function found(entries: readonly Entry[], text: string): Entry[] {
    const words = text.toLowerCase().split(/\s+/).filter((one) => one !== '');
    const rank = (entry: Entry) => entry.text.toLowerCase().startsWith(words[0] ?? '') ? 0 : 1;
    return entries.filter((entry) => words.every((one) =>
        `${entry.text} ${entry.group}`.toLowerCase().includes(one)))
        .map((entry, i) => ({ entry, i }))
        .sort((a, b) => rank(a.entry) - rank(b.entry) || a.i - b.i)
        .map(({ entry }) => entry).slice(0, kMost);
}

function Option({ entry, index, onRun }: { entry: Entry; index: number; onRun: (entry: Entry) => void }) {
    const row = useRef<HTMLDivElement>(null);
    const isActive = at.value === index;
    useEffect(() => {
        if (isActive) {
            row.current?.scrollIntoView({ block: 'nearest' });
        }
    }, [isActive]);
    return (
        <div role="option" id={`palette-${index}`} ref={row} aria-selected={isActive}
            onPointerMove={() => { at.value = index; }} onClick={() => onRun(entry)}>
            <span class="text">{entry.text}</span>
            <span class="group">{entry.group}</span>
            <span class="keys">{entry.key === '' ? null
                : keyWords(entry.key).map((one) => <kbd key={one}>{one}</kbd>)}</span>
        </div>
    );
}

export function Palette() {
    const dialog = useRef<HTMLDialogElement>(null);
    useEffect(() => {
        word.value = '';
        at.value = 0;
        dialog.current?.showModal();
    }, []);
    const entries = found(allEntries(), word.value);
    const run = (entry: Entry | undefined) => {
        dialog.current?.close();
        entry?.run();
    };
    const onKey = (event: KeyboardEvent) => {
        const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
        if (step && entries.length > 0) {
            at.value = (at.value + step + entries.length) % entries.length;
        } else if (event.key === 'Enter') {
            run(entries[at.value]);
        } else {
            return;
        }
        event.preventDefault();
    };
    return (
        <dialog class="palette" ref={dialog} aria-label="Commands"
            onClose={() => { if (panel.peek() === 'palette') { panel.value = null; } }}
            onClick={(event) => { if (event.target === dialog.current) { dialog.current?.close(); } }}>
            <input type="text" role="combobox" aria-label="Find a command" autofocus spellcheck={false}
                placeholder="Find a command, an object, or something to add"
                aria-expanded aria-controls="palette-list" aria-activedescendant={`palette-${at.value}`}
                value={word.value} onKeyDown={onKey}
                onInput={(event) => { word.value = event.currentTarget.value; at.value = 0; }} />
            <div role="listbox" id="palette-list" aria-label="Commands" tabIndex={-1}>
                {entries.map((entry, i) => (
                    <Option key={`${entry.group} ${entry.text} ${i}`} entry={entry} index={i} onRun={run} />
                ))}
                {entries.length === 0 ? <p>No matches.</p> : null}
            </div>
        </dialog>
    );
}
