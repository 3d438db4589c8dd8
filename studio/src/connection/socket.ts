/// The one socket to the server: connects, says hello, and connects again when it was lost.
import { connection } from '../state/state';
import { kProtocol, type ToServer } from '../protocol';
import { receive } from './receive';

/// Waiting times between attempts to connect again, in milliseconds; the last one repeats.
const kBackOff = [250, 500, 1000, 2000, 4000];

let socket: WebSocket | null = null;
let attempts = 0;

/// The address of the server's socket: the host that the page came from.
function address(): string {
    const scheme = location.protocol === 'https:' ? 'wss:' : 'ws:';
    return `${scheme}//${location.host}/socket`;
}

/// Sends one message. Returns false, and sends nothing, while there is no connection.
export function send<Name extends keyof ToServer>(name: Name, message: ToServer[Name]): boolean {
    if (!socket || socket.readyState !== WebSocket.OPEN) {
        return false;
    }
    socket.send(JSON.stringify({ t: name, ...message }));
    return true;
}

function reconnectLater(): void {
    const wait = kBackOff[Math.min(attempts, kBackOff.length - 1)] ?? 1000;
    attempts += 1;
    setTimeout(connect, wait);
}

/// Connects, and from then on connects again by itself whenever the connection is lost.
export function connect(): void {
    const opened = new WebSocket(address());
    opened.binaryType = 'arraybuffer';
    socket = opened;
    opened.onopen = () => {
        attempts = 0;
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
    opened.onclose = () => {
        if (socket === opened) {
            socket = null;
            connection.value = 'lost';
            reconnectLater();
        }
    };
}
