/// Small pictures of the film's frames, as they are made.
import { signal } from '@preact/signals';

/// The address of each frame's picture; empty if the frame is made but has no picture. A new map
/// whenever a frame comes.
export const filmThumbnails = signal<ReadonlyMap<number, string>>(new Map());
