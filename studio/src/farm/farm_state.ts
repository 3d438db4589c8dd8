/// What the page shows, and its socket.
import { signal } from '@preact/signals';
import { newestKey, onNewKey } from '../connection/key';
import type { JobFrames, JobList, Message } from './farm_types';

const kReconnect = 2000; // ms

export const connection = signal<'connecting' | 'open' | 'lost' | 'refused'>('connecting');
export const list = signal<JobList | null>(null);
/// Why the jobs of the store cannot be listed, and why the job that is shown cannot be read.
export const listProblem = signal('');
export const jobProblem = signal('');
/// The id of the job that is shown, which the address has behind "#"; empty: none.
export const shownJob = signal('');
export const frames = signal<JobFrames | null>(null);
/// The number of the newest contact sheet of the shown job; 0: there is none yet.
export const sheet = signal(0);

let socket: WebSocket | null = null;

/// Tells the server which job is shown.
function askForJob(): void {
    if (socket?.readyState === WebSocket.OPEN) {
        socket.send(shownJob.value);
    }
}

function show(job: string): void {
    if (shownJob.value !== job) {
        shownJob.value = job;
        frames.value = null;
        sheet.value = 0;
        jobProblem.value = '';
        askForJob();
    }
}

/// Takes a message of the server. One about a job that is no longer shown is dropped.
export function receive(message: Message): void {
    if (message.t !== 'list' && message.job !== shownJob.value) {
        return;
    }
    if (message.t === 'sheet') {
        sheet.value = message.number;
        return;
    }
    (message.t === 'list' ? listProblem : jobProblem).value = 'problem' in message ? message.problem : '';
    if ('problem' in message) {
        return;
    }
    if (message.t === 'list') {
        list.value = message.data;
    } else {
        frames.value = message.data;
        sheet.value = message.sheet;
    }
}

async function isRefused(key: string): Promise<boolean> {
    return key === '' || (await fetch(`/?key=${key}`).catch(() => null))?.status === 401;
}

/// Connects, and connects again by itself whenever the connection is lost.
export function connect(): void {
    const key = newestKey();
    const opened = new WebSocket(`ws://${location.host}/socket`, ['carom', `carom.key.${key}`]);
    let wasOpen = false;
    socket = opened;
    opened.onopen = () => {
        wasOpen = true;
        connection.value = 'open';
        askForJob();
    };
    opened.onmessage = (event) => receive(JSON.parse(event.data as string) as Message);
    opened.onclose = async () => {
        const refused = !wasOpen && await isRefused(key);
        connection.value = refused ? 'refused' : 'lost';
        if (!refused || key !== newestKey()) {
            setTimeout(connect, kReconnect);
        }
    };
}

/// The id behind "#" of the address; empty if there is none.
function addressedJob(): string {
    try {
        return decodeURIComponent(location.hash.slice(1));
    } catch {
        return ''; // no address of this page
    }
}

/// Follows the address, and new keys of other windows; to be called once.
export function watchAddress(): void {
    const follow = () => show(addressedJob());
    window.addEventListener('hashchange', follow);
    follow();
    onNewKey(() => connection.value === 'refused' && connect());
}
