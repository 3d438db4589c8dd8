/// The cameras of all frames of the film, as the server planned them.
import type { CameraPose } from './camera';
import { mixPoses } from './camera';
import { kCamerasNumbersPerFrame } from '../protocol';

/// What a frame of the film shows of one camera.
export interface PlannedEntry {
    frame: number;
    camera: number; // index in ShotState.cameras
    weight: number; // below 1 in a cross-fade
    filmTime: number;
    sceneTime: number;
    shutterOpens: number; // scene times
    shutterCloses: number;
    speed: number;
    pose: CameraPose; // in the middle of the exposure
}

/// The entries of one camera, in the order of frames, over the numbers of a message.
export class CameraFramesOf {
    private readonly entries: number[] = []; // indices in the message

    constructor(private readonly numbers: Float64Array, readonly camera: number) {
        const count = Math.floor(numbers.length / kCamerasNumbersPerFrame);
        for (let entry = 0; entry < count; ++entry) {
            if (numbers[entry * kCamerasNumbersPerFrame + 1] === camera) {
                this.entries.push(entry);
            }
        }
    }

    get count(): number {
        return this.entries.length;
    }

    /// The entry with the given index, in [0, count).
    at(index: number): PlannedEntry {
        const first = (this.entries[index] ?? 0) * kCamerasNumbersPerFrame;
        const n = (i: number) => this.numbers[first + i] ?? 0;
        return {
            frame: n(0), camera: n(1), weight: n(2), filmTime: n(3), sceneTime: n(4),
            shutterOpens: n(5), shutterCloses: n(6), speed: n(7),
            pose: {
                position: [n(8), n(9), n(10)],
                target: [n(11), n(12), n(13)],
                up: [n(14), n(15), n(16)],
                roll: n(17), verticalFov: n(18), focusDistance: n(19), lensRadius: n(20),
            },
        };
    }

    /// The pose at a film time, between two frames a mixture of theirs; null without frames.
    poseAt(filmTime: number): CameraPose | null {
        if (this.count === 0) {
            return null;
        }
        let low = 0;
        let high = this.count - 1;
        while (low < high) {
            const middle = (low + high + 1) >> 1;
            if (this.at(middle).filmTime <= filmTime + 1e-9) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        const before = this.at(low);
        if (low + 1 >= this.count) {
            return before.pose;
        }
        const after = this.at(low + 1);
        const weight = (filmTime - before.filmTime) / (after.filmTime - before.filmTime);
        return weight <= 1e-6 ? before.pose
            : mixPoses(before.pose, after.pose, Math.min(weight, 1));
    }
}
