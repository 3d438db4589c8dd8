/// A page that is connected to a socket which only listens, with one text open.
import { receive } from '../../src/connection/receive';
import { connect } from '../../src/connection/socket';
import { buffers } from '../../src/text/buffers';
import { takeFiles } from '../../src/text/take_files';

/// What the page sent since it was opened.
export const sent: { t: string; v: number; text: string }[] = [];

class Listening {
    static readonly OPEN = 1;
    readonly readyState = 1;
    onopen: (() => void) | null = null;
    constructor() {
        queueMicrotask(() => this.onopen?.());
    }
    send(text: string): void {
        sent.push(JSON.parse(text));
    }
}

/// A message of the server arrives.
export function tell(t: string, fields: object): void {
    receive(JSON.stringify({ t, ...fields }));
}

/// Connects the page and opens /a.yaml with this text.
export async function openText(text: string, writable = true): Promise<void> {
    Object.assign(globalThis, {
        WebSocket: Listening, location: { protocol: 'http:', host: 'x' }, localStorage: { getItem: () => 'k' },
    });
    connect();
    await Promise.resolve();
    buffers.value = [];
    tell('welcome', { protocol: '', version: '', v: 1, shot: '/a.yaml', root: '/', output: '' });
    const files = [{ file: '/a.yaml', name: 'a', text, hash: 'a', writable, changed: false }];
    tell('files', { v: 1, files });
    takeFiles(files);
    sent.length = 0;
}
