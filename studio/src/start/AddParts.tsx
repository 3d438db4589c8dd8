/// "Add from file": a list of what another shot has, of which some can be added to this one.
import { signal } from '@preact/signals';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { openDialog } from '../dialogs/open_dialogs';
import { insertParts } from '../edit/edit';
import type { Part } from '../protocol';
import { notice } from '../state/state';
import { pickShot } from './OpenShot';
import './files.css';

/// Where the parts are: a file, or a text.
export interface PartSource {
    file: string;
    text: string;
    name: string;
}

const kTitles: Record<string, string> = {
    balls: 'Balls', objects: 'Objects', lights: 'Lights', cameras: 'Cameras',
    materials: 'Materials',
};

const parts = signal<Part[] | null>(null);
const chosen = signal<ReadonlySet<Part>>(new Set());

function choose(some: readonly Part[], isOn: boolean): void {
    const next = new Set(chosen.value);
    some.forEach((part) => { isOn ? next.add(part) : next.delete(part); });
    chosen.value = next;
}

function Row({ part }: { part: Part }) {
    return (
        <label class="part">
            <input type="checkbox" checked={chosen.value.has(part)}
                onChange={(event) => choose([part], event.currentTarget.checked)} />
            <span class="name">{part.name}</span>
            <span class="about" title={part.about}>{part.about}</span>
            {part.exists
                ? <span class="hint" title="This shot has one of that name: it gets another name">
                    renamed
                </span> : null}
        </label>
    );
}

function Section({ section, list }: { section: string; list: Part[] }) {
    const count = list.filter((part) => chosen.value.has(part)).length;
    return (
        <fieldset class="section">
            <legend>
                <label>
                    <input type="checkbox" checked={count === list.length}
                        ref={(box) => {
                            if (box) {
                                box.indeterminate = count > 0 && count < list.length;
                            }
                        }}
                        onChange={(event) => choose(list, event.currentTarget.checked)} />
                    {kTitles[section] ?? section}
                </label>
            </legend>
            {list.map((part) => <Row key={part.name} part={part} />)}
        </fieldset>
    );
}

function Checklist() {
    const all = parts.value;
    if (!all) {
        return <p>…</p>;
    }
    const sections = Object.keys(kTitles)
        .map((section) => ({ section, list: all.filter((part) => part.section === section) }))
        .filter(({ list }) => list.length > 0);
    return sections.length === 0 ? <p>This file has nothing that can be added.</p> : (
        <div class="checklist">
            {sections.map(({ section, list }) =>
                <Section key={section} section={section} list={list} />)}
        </div>
    );
}

/// Shows the checklist of a file and adds what the user chooses, as one step of undo.
export function addParts({ file, text, name }: PartSource): Promise<void> {
    parts.value = null;
    chosen.value = new Set();
    return new Promise((resolve) => {
        const stop: (() => void)[] = [];
        const end = () => {
            stop.forEach((one) => one());
            resolve();
        };
        const close = openDialog({
            title: `Add from ${name}`, size: 'wide', onDismiss: end, body: () => <Checklist />,
            actions: () => [{
                label: chosen.value.size === 0 ? 'Add' : `Add ${chosen.value.size}`,
                kind: 'primary', isDisabled: chosen.value.size === 0,
                run: () => {
                    const names = [...chosen.value].map((part) =>
                        ({ section: part.section, name: part.name }));
                    send('add_parts', { file, text, parts: names });
                },
            }],
        });
        stop.push(onMessage('parts', (message) => { parts.value = message.parts; }));
        stop.push(onMessage('additions', ({ list }) => {
            if (insertParts(list, `Add from ${name}`).ok) {
                notice.value = {
                    kind: 'info', text: `${list.map((one) => one.name).join(', ')} added.`,
                };
            }
            end();
        }));
        stop.push(onMessage('failed', ({ what }) => {
            if (what === 'read_parts' || what === 'add_parts') {
                close();
                end();
            }
        }));
        send('read_parts', { file, text });
    });
}

/// Lets the user choose a file below the root to add from.
export async function addFromFile(): Promise<void> {
    const file = await pickShot('Add from a shot');
    if (file !== null) {
        await addParts({ file, text: '', name: file.split('/').pop() ?? file });
    }
}
