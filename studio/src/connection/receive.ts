/// Writes what the server sends into the signals of src/state. Of each kind the newest version
/// wins: an answer about older texts than the last one shown is dropped.
import { batch } from '@preact/signals';
import type { BinaryToPage, ToPage } from '../protocol';
import { kBinaryTypes } from '../protocol';
import {
    cameraFrames, deferred, fan, files, judged, meshes, picture, pictureAsked, problems, sceneAnnotations, sequence, shot, solutions, soundState, start, strikeMap, textVersion, timeline, welcome, work,
    type CameraFrames,
} from '../state/state';
import { asFloat64, decodeBinary } from './decode';

type Listener<Name extends keyof ToPage> = (message: ToPage[Name]) => void;
/// A version of the shot whose motion has not come yet, and its cameras.
interface Awaited {
    shot: ToPage['shot'];
    cameras: CameraFrames | null;
}

type Handlers<Map> = { [Name in keyof Map]?: (message: Map[Name], payload: ArrayBuffer) => void };

let awaited: Awaited | null = null;

const listeners = new Map<keyof ToPage, Set<Listener<never>>>();

/// Calls `listener` for every later message of this name, after the signals were written. Returns a
/// function that ends this.
export function onMessage<Name extends keyof ToPage>(
    name: Name, listener: Listener<Name>,
): () => void {
    const all = listeners.get(name) ?? new Set();
    listeners.set(name, all);
    all.add(listener as Listener<never>);
    return () => all.delete(listener as Listener<never>);
}

/// Whether a message of version `v` is at least as new as what is shown.
function isNewer(v: number, shown: number | undefined): boolean {
    return shown === undefined || v >= shown;
}

/// Shows the shot of a version whose motion came: everything that depends on both is done once.
function showAwaited(v: number): void {
    if (awaited?.shot.v === v) {
        shot.value = awaited.shot;
        cameraFrames.value = awaited.cameras ?? cameraFrames.value;
        awaited = null;
    }
}

const texts: Handlers<ToPage> = {
    welcome: (message) => {
        forgetVersions();
        welcome.value = message;
        textVersion.value = message.v;
    },
    start: (message) => {
        start.value = message;
    },
    files: (message) => {
        files.value = message.files;
        textVersion.value = Math.max(textVersion.value, message.v);
    },
    text_changed: (message) => {
        textVersion.value = Math.max(textVersion.value, message.v);
    },
    problems: (message) => {
        if (isNewer(message.v, problems.value?.v)) {
            problems.value = message;
        }
    },
    shot: (message) => {
        if (isNewer(message.v, shot.value?.v) && isNewer(message.v, sequence.value?.v)) {
            sequence.value = null;
            awaited = message.moves ? { shot: message, cameras: null } : null;
            shot.value = message.moves ? shot.value : message;
        }
    },
    sequence: (message) => {
        if (isNewer(message.v, sequence.value?.v) && isNewer(message.v, shot.value?.v)) {
            forgetShot();
            sequence.value = message;
        }
    },
    scene: (message) => {
        meshes.value = message.hash;
    },
    sound: (message) => {
        soundState.value = message;
    },
    judged: (message) => {
        judged.value = message;
    },
    strike_map: (message) => {
        strikeMap.value = message;
    },
    work: (message) => {
        work.value = message;
    },
    failed: (message) => {
        if (message.what === 'picture') {
            pictureAsked.value = false;
        }
    },
    deferred: (message) => {
        deferred.value = message;
    },
};

const binaries: Handlers<BinaryToPage> = {
    timeline: (head, payload) => {
        if (isNewer(head.v, timeline.value?.head.v)) {
            showAwaited(head.v);
            timeline.value = { head, numbers: asFloat64(payload) };
        }
    },
    cameras: (head, payload) => {
        if (isNewer(head.v, cameraFrames.value?.head.v)) {
            const frames = { head, numbers: asFloat64(payload) };
            if (awaited?.shot.v === head.v) {
                awaited.cameras = frames;
            } else {
                cameraFrames.value = frames;
            }
        }
    },
    fan: (head, payload) => {
        fan.value = { head, numbers: asFloat64(payload) };
    },
    solutions: (head, payload) => {
        solutions.value = { head, numbers: asFloat64(payload) };
    },
    annotations: (head, payload) => {
        sceneAnnotations.value = { head, numbers: asFloat64(payload) };
    },
    picture: (head, payload) => {
        picture.value = { head, pixels: new Uint8ClampedArray(payload) };
    },
};

function receiveText(text: string): void {
    const { t, ...fields } = JSON.parse(text) as { t: keyof ToPage };
    const message = fields as never;
    batch(() => texts[t]?.(message, new ArrayBuffer(0)));
    for (const listener of listeners.get(t) ?? []) {
        listener(message);
    }
}

function receiveBinary(data: ArrayBuffer): void {
    const { type, head, payload } = decodeBinary(data);
    const name = kBinaryTypes[type];
    if (name) {
        batch(() => binaries[name]?.(head as never, payload));
    }
}

/// Takes one message of the socket. Throws if it is not well formed.
export function receive(data: string | ArrayBuffer): void {
    if (typeof data === 'string') {
        receiveText(data);
    } else {
        receiveBinary(data);
    }
}

/// Forgets what was told about the shot, because a new connection tells it again with versions that
/// may begin anew.
export function forgetVersions(): void {
    batch(() => {
        problems.value = null;
        sequence.value = null;
        soundState.value = null;
        forgetShot();
    });
}

function forgetShot(): void {
    awaited = null;
    shot.value = null;
    timeline.value = null;
    cameraFrames.value = null;
    fan.value = null;
    solutions.value = null;
    judged.value = null;
    strikeMap.value = null;
    sceneAnnotations.value = null;
    work.value = null;
    deferred.value = null;
    pictureAsked.value = false;
}
