/// The groups of what is open: a shot, or a film of several.
import { computed } from '@preact/signals';
import { sequence, shot } from '../state/state';
import { groupsOfSequence, outlineGroups, type OutlineGroup } from './outline_groups';

export const groupsNow = computed<OutlineGroup[]>(() =>
    sequence.value ? groupsOfSequence(sequence.value) : shot.value ? outlineGroups(shot.value) : []);
