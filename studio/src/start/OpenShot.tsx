/// The dialog that leads through the folders below the root to a shot.
import { signal } from '@preact/signals';
import { ChevronRight, FileText, Folder as FolderIcon } from 'lucide-preact';
import { useEffect, useRef } from 'preact/hooks';
import { onMessage } from '../connection/receive';
import { send } from '../connection/socket';
import { openDialog } from '../dialogs/open_dialogs';
import type { Folder, FolderEntry } from '../protocol';
import { welcome } from '../state/state';
import { openShot } from './file_actions';
import './files.css';

const folder = signal<Folder | null>(null);

/// The folders from the root to the shown one, with their names.
function waysTo(shown: Folder): { name: string; path: string }[] {
    const root = shown.folder.slice(0, shown.folder.length - shown.name.length).replace(/\/$/, '');
    const names = shown.name === '' ? [] : shown.name.split('/');
    const first = { name: root.split('/').pop() || '/', path: root || '/' };
    return [first, ...names.map((name, i) => ({
        name, path: `${root}/${names.slice(0, i + 1).join('/')}`,
    }))];
}

function look(path: string): void {
    send('list', { folder: path });
}

function Entry({ entry, isFirst, choose }: {
    entry: FolderEntry; isFirst: boolean; choose(entry: FolderEntry): void;
}) {
    const Icon = entry.is_folder ? FolderIcon : FileText;
    const isOpen = entry.file === welcome.value?.shot;
    return (
        <li>
            <button type="button" data-focus={isFirst || undefined} onClick={() => choose(entry)}>
                <Icon size={16} strokeWidth={1.5} aria-hidden="true" />
                <span>{entry.name}</span>
                {isOpen ? <span class="hint">open</span> : null}
            </button>
        </li>
    );
}

function walk(event: KeyboardEvent): void {
    const list = event.currentTarget as HTMLElement;
    const buttons = [...list.querySelectorAll('button')];
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    const step = event.key === 'ArrowDown' ? 1 : event.key === 'ArrowUp' ? -1 : 0;
    if (step !== 0) {
        event.preventDefault();
        buttons[at + step]?.focus();
    }
}

function Browser({ choose }: { choose(entry: FolderEntry): void }) {
    const shown = folder.value;
    const list = useRef<HTMLUListElement>(null);
    useEffect(() => list.current?.querySelector('button')?.focus(), [shown?.folder]);
    if (!shown) {
        return <p>…</p>;
    }
    const ways = waysTo(shown);
    return (
        <>
            <nav class="ways_to" aria-label="Folder">
                {ways.map(({ name, path }, i) => (
                    <>
                        {i > 0 ? <ChevronRight size={14} aria-hidden="true" /> : null}
                        <button type="button" disabled={i === ways.length - 1}
                            onClick={() => look(path)}>{name}</button>
                    </>
                ))}
            </nav>
            <ul class="entries" ref={list} aria-label="Shots and folders" onKeyDown={walk}>
                {shown.entries.map((entry, i) => (
                    <Entry key={entry.file} entry={entry} isFirst={i === 0} choose={choose} />
                ))}
                {shown.entries.length === 0
                    ? <li class="nothing">There is no shot in this folder.</li> : null}
            </ul>
        </>
    );
}

/// Lets the user choose a shot below the root. Resolves to its path, or to null.
export function pickShot(title: string): Promise<string | null> {
    folder.value = null;
    return new Promise((resolve) => {
        const stop = onMessage('folder', (message) => { folder.value = message; });
        const end = (file: string | null) => {
            stop();
            close();
            resolve(file);
        };
        const choose = (entry: FolderEntry) => {
            if (entry.is_folder) {
                look(entry.file);
            } else {
                end(entry.file);
            }
        };
        const close = openDialog({
            title, body: () => <Browser choose={choose} />, onDismiss: () => end(null),
        });
        look('');
    });
}

export async function chooseShot(): Promise<void> {
    const file = await pickShot('Open a shot');
    if (file !== null) {
        await openShot(file);
    }
}
