/// Files that another program deletes, and that come back.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { receive } from '../../src/connection/receive';
import { notice } from '../../src/state/state';
import { buffers, isChanged, textOf } from '../../src/text/buffers';
import { conflictOf } from '../../src/text/disk_conflicts';
import { watchFiles } from '../../src/text/saving';

const kText = 'balls: {cue: {at: [0, 0]}}\n';

function tell(t: string, message: object): void {
    receive(JSON.stringify({ t, ...message }));
}

function tellFiles(v: number, text: string, hash: string, changed: boolean): void {
    tell('files', { v, files: [
        { file: '/a.yaml', name: 'a.yaml', text, hash, writable: true, changed }] });
}

function tellGone(): void {
    tell('disk_changed', { file: '/a.yaml', text: '', hash: '', gone: 'was deleted', refused: false });
}

const shown = () => textOf(buffers.value[0]!);
const isUnsaved = () => isChanged(buffers.value[0]!);

watchFiles();

beforeEach(() => {
    buffers.value = [];
    tell('welcome', { protocol: '', version: '', v: 1, shot: '/a.yaml', root: '/', output: '' });
    tellFiles(1, kText, 'a', false);
});

test('DiskChanged_FileIsDeleted_KeepsItsTextAsUnsaved', () => {
    assert.equal(isUnsaved(), false);
    tellGone();
    assert.deepEqual([shown(), isUnsaved(), conflictOf('/a.yaml')?.gone], [kText, true, 'was deleted']);
    assert.match(notice.value!.text, /^a\.yaml was deleted\. The text is still here/);
    tell('saved', { file: '/a.yaml', hash: 'b' });
    assert.deepEqual([shown(), isUnsaved(), conflictOf('/a.yaml')], [kText, false, undefined]);
});

test('DiskChanged_DeletedFileComesBack_IsNoConflict', () => {
    tellGone();
    tellFiles(2, kText, 'a', false);
    assert.deepEqual([shown(), isUnsaved(), conflictOf('/a.yaml')], [kText, false, undefined]);
    // With another text, which is taken if the page has changed nothing.
    tellGone();
    const theirs = kText.replace('[0, 0]', '[1, 0]');
    tell('disk_changed', { file: '/a.yaml', text: theirs, hash: 'c', gone: '', refused: false });
    assert.deepEqual([shown(), isUnsaved(), conflictOf('/a.yaml')], [theirs, false, undefined]);
});
