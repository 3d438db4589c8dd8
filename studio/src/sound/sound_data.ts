/// The samples of a film's sound as they come, in pieces, and the peaks that the strip draws.

/// What of the film's sound is where.
export interface SoundExtent {
    rate: number; // samples per second
    samples: number; // of each channel, of the whole film
    piece: number; // of each piece; the last one may be shorter
}

const kFullScale = 32767;
const kBin = 240; // samples: peaks of 5 ms are kept

/// The highest magnitude of either channel, in [0, 1], in each bin of a piece.
export function binPeaks(piece: Int16Array, bin: number): Float32Array {
    const peaks = new Float32Array(Math.ceil(piece.length / (2 * bin)));
    for (let i = 0; i < piece.length; i += 1) {
        const at = Math.floor(i / (2 * bin));
        const value = Math.min(1, Math.abs(piece[i] ?? 0) / kFullScale);
        if (value > (peaks[at] ?? 0)) {
            peaks[at] = value;
        }
    }
    return peaks;
}

export class SoundData {
    private readonly pieces = new Map<number, Int16Array>();
    private readonly bins = new Map<number, Float32Array>();

    constructor(readonly address: string, readonly extent: SoundExtent) {}

    /// s
    get duration(): number {
        return this.extent.samples / this.extent.rate;
    }

    has(index: number): boolean {
        return this.pieces.has(index);
    }

    /// A piece that came: a left and a right number for each sample.
    add(index: number, piece: Int16Array): void {
        this.pieces.set(index, piece);
        this.bins.set(index, binPeaks(piece, kBin));
    }

    /// Both channels of samples of one piece in [-1, 1], from a sample of it on; empty if the piece
    /// has not come.
    channels(index: number, from: number, count: number): [Float32Array, Float32Array] {
        const piece = this.pieces.get(index);
        const most = Math.max(0, Math.min(count, (piece?.length ?? 0) / 2 - from));
        const [left, right] = [new Float32Array(most), new Float32Array(most)];
        for (let i = 0; i < most; i += 1) {
            left[i] = (piece?.[2 * (from + i)] ?? 0) / kFullScale;
            right[i] = (piece?.[2 * (from + i) + 1] ?? 0) / kFullScale;
        }
        return [left, right];
    }

    /// The highest magnitude between two times of the film (s), in [0, 1]; null if nothing of that
    /// has come. It is exact for short stretches, and by whole bins for long ones.
    peak(from: number, to: number): number | null {
        const { rate, samples, piece } = this.extent;
        const first = Math.max(0, Math.floor(from * rate));
        const end = Math.min(samples, Math.max(first + 1, Math.ceil(to * rate)));
        let highest: number | null = null;
        for (let at = first; at < end;) {
            const index = Math.floor(at / piece);
            const until = Math.min(end, (index + 1) * piece);
            const found = this.peakIn(index, at - index * piece, until - index * piece);
            highest = found === null ? highest : Math.max(highest ?? 0, found);
            at = until;
        }
        return highest;
    }

    private peakIn(index: number, from: number, to: number): number | null {
        const piece = this.pieces.get(index);
        const bins = this.bins.get(index);
        if (!piece || !bins) {
            return null;
        }
        let highest = 0;
        if (to - from < 2 * kBin) {
            for (let i = 2 * from; i < 2 * to; i += 1) {
                highest = Math.max(highest, Math.abs(piece[i] ?? 0) / kFullScale);
            }
            return Math.min(1, highest);
        }
        for (let bin = Math.floor(from / kBin); bin * kBin < to; bin += 1) {
            highest = Math.max(highest, bins[bin] ?? 0);
        }
        return highest;
    }
}
