/// The one socket to the server: connects, says hello, and connects again when it was lost.
import { connection, notice } from '../state/state';
import { kLongestMessage, kProtocol, type ToServer } from '../protocol';
import { newestKey, onNewKey } from './key';
import { receive } from './receive';

/// Waiting times between attempts to connect again, in milliseconds; the last one repeats.
const kBackOff = [250, 500, 1000, 2000, 4000];

/// The longest text, in words.
export const kLongestText = `${Math.floor(kLongestMessage / (1 << 20))} MiB`;

let socket: WebSocket | null = null;
let attempts = 0;

/// The address of the server's socket: the host that the page came from.
function address(): string {
    const scheme = location.protocol === 'https:' ? 'wss:' : 'ws:';
    return `${scheme}//${location.host}/socket`;
}

/// Whether the message has more bytes than the server takes: it would close the socket.
function isTooLong(message: string): boolean {
    return 3 * message.length > kLongestMessage // the most bytes that its characters may take
        && new TextEncoder().encode(message).length > kLongestMessage;
}

/// Sends one message. Returns 'lost', and sends nothing, while there is no connection; 'too long' if
/// the server would not take it.
export function trySend<Name extends keyof ToServer>(
    name: Name, message: ToServer[Name],
): 'sent' | 'lost' | 'too long' {
    if (!socket || socket.readyState !== WebSocket.OPEN) {
        return 'lost';
    }
    const text = JSON.stringify({ t: name, ...message });
    if (isTooLong(text)) {
        return 'too long';
    }
    socket.send(text);
    return 'sent';
}

/// The same; the user is told what is too long. Returns whether it was sent.
export function send<Name extends keyof ToServer>(name: Name, message: ToServer[Name]): boolean {
    const result = trySend(name, message);
    if (result === 'too long') {
        notice.value = { kind: 'error', text: `The text is too long: carom studio takes at most ${kLongestText}.` };
    }
    return result === 'sent';
}

/// Whether the server at this address does not know the key: it is another one than the page's.
async function isRefused(key: string): Promise<boolean> {
    if (key === '') {
        return true;
    }
    const answer = await fetch(`/?key=${key}`).catch(() => null);
    return answer?.status === 401;
}

function reconnectLater(): void {
    const wait = kBackOff[Math.min(attempts, kBackOff.length - 1)] ?? 1000;
    attempts += 1;
    setTimeout(connect, wait);
}

/// Connects, and from then on connects again by itself whenever the connection is lost. Where the
/// server refuses the key, that waits for a new key.
export function connect(): void {
    const key = newestKey();
    const opened = new WebSocket(address(), ['carom', `carom.key.${key}`]);
    let wasOpen = false;
    opened.binaryType = 'arraybuffer';
    socket = opened;
    opened.onopen = () => {
        attempts = 0;
        wasOpen = true;
        connection.value = 'open';
        send('hello', { protocol: kProtocol });
    };
    opened.onmessage = (event) => {
        try {
            receive(event.data as string | ArrayBuffer);
        } catch (error) {
            console.error('a message of the server could not be read:', error);
        }
    };
    opened.onclose = async () => {
        if (socket !== opened) {
            return;
        }
        socket = null;
        const refused = !wasOpen && await isRefused(key);
        connection.value = refused ? 'refused' : 'lost';
        if (!refused || key !== newestKey()) {
            reconnectLater();
        }
    };
}

/// To be called once.
export function watchKeys(): void {
    onNewKey(() => connection.value === 'refused' && connect());
}
