/// What a gesture on the last scene without errors may write into a later text.
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { receive } from '../../src/connection/receive';
import { beginGesture } from '../../src/edit/edit';
import { meansTheSame } from '../../src/edit/scene_paths';
import type { SourceFile } from '../../src/edit/edit_types';
import { notice, shot } from '../../src/state/state';
import type { ShotState } from '../../src/protocol';
import { buffers, setChangeListener, setText, textOf } from '../../src/text/buffers';
import { sendSoon, watchAnswers } from '../../src/text/sending';
import { takeFiles } from '../../src/text/take_files';

const kShot = `include: x.yaml
balls:
  cue: {at: [0, 0]}
objects:
  box: {box: [1, 1, 1], repeat: {count: 3, step: [1, 0, 0]}}
events:
  - strike: {ball: cue, speed: 1}
  - strike: {ball: one, speed: 2}
cameras:
  - name: wide
    position: {bezier: [[0, 0, 1], [1, 0, 1], [2, 0, 1]]}
`;

function files(shotText: string, config = 'rack: {gap: 1 mm}\n'): SourceFile[] {
    return [
        { file: '/a.yaml', name: 'a.yaml', text: shotText, writable: true },
        { file: '/x.yaml', name: 'x.yaml', text: config, writable: true },
    ];
}

test('MeansTheSame_InALaterText_HoldsForWhatIsWhereItWas', () => {
    const same = (path: string, change: (text: string) => string, config?: string) =>
        meansTheSame(path.split('.'), files(kShot), files(change(kShot), config));
    const broken = (text: string) => text.replace('name: wide', 'nam: wide');
    for (const path of ['balls.cue.at', 'events.1.strike.speed', 'objects.box.box.0', 'rack.gap',
        'cameras.0.position.bezier.2', 'objects.box_1.at', 'balls.four.at']) {
        assert.ok(same(path, broken), path);
        assert.ok(same(path, (text) => text), path);
    }
    // Items of lists that are elsewhere now, or gone.
    const inserted = (text: string) => text.replace('events:\n', 'events:\n  - impulse: {}\n');
    const removed = (text: string) => text.replace('  - strike: {ball: cue, speed: 1}\n', '');
    assert.ok(same('events.0.strike.speed', inserted) === false);
    assert.ok(same('events.1.strike.speed', inserted) === false);
    assert.ok(same('events.1.strike.speed', removed) === false);
    const misspelled = (text: string) => text.replace('speed: 1', 'spee: 1');
    assert.ok(same('events.0.strike.speed', misspelled) === false);
    assert.ok(same('events.0.strike.ball', misspelled) && same('events.1.strike.speed', misspelled));
    assert.ok(same('cameras.0.position.bezier.2', (text) => text.replace('[0, 0, 1], ', '')) === false);
    assert.ok(same('cameras.0.position.bezier.0', (text) => text.replace('[0, 0, 1], ', '')) === false);
    // What is gone, and what followed from something that is another now.
    assert.ok(same('balls.cue.at', (text) => text.replace('cue: {at: [0, 0]}', 'cu: {}')) === false);
    const unrepeated = (text: string) => text.replace('repeat', 'repaet');
    assert.ok(same('objects.box_1.at', unrepeated) === false);
    assert.ok(same('objects.box.box.0', unrepeated));
    assert.ok(same('objects.box_1.at', (text) => text.replace('  box:', '  box_2: {at: [0, 0, 0]}\n  box:')));
    assert.ok(same('balls.four.at', (text) => text, 'rack: {gp: 1 mm}\n') === false);
});

function tell(t: string, message: object): void {
    receive(JSON.stringify({ t, ...message }));
}

watchAnswers();
setChangeListener(sendSoon);

beforeEach(async () => {
    buffers.value = [];
    tell('welcome', { protocol: '', version: '', v: 1, shot: '/a.yaml', root: '/', output: '' });
    const list = files(kShot).map((one) => ({ ...one, hash: 'a', changed: false }));
    tell('files', { v: 1, files: list });
    takeFiles(list);
    await Promise.resolve();
    shot.value = { v: 1 } as ShotState;
});

test('Gesture_OfTheSceneOnABrokenText_WritesOnlyWhatIsThere', () => {
    const drag = (path: string) => {
        const gesture = beginGesture(true);
        const result = gesture.update([{ path: path.split('.'), value: 7 }]);
        gesture.commit('Move');
        return result.ok;
    };
    setText('/a.yaml', kShot.replace('repeat', 'repaet'), 'Type');
    const before = textOf(buffers.value[0]!);
    tell('problems', { v: 1, complete: true, list: [{ severity: 'error' }] });
    assert.equal(drag('objects.box_1.at'), false);
    assert.match(notice.value!.text, /'objects\.box_1' is not where it was.*must be mended first/);
    assert.equal(textOf(buffers.value[0]!), before);
    assert.equal(drag('objects.box.box.0'), true);
    assert.equal(textOf(buffers.value[0]!), before.replace('box: [1,', 'box: [7,'));
    setText('/a.yaml', kShot.replace('  - strike: {ball: cue, speed: 1}\n', ''), 'Type');
    assert.equal(drag('events.1.strike.speed'), false);
    assert.equal(drag('events.0.strike.speed'), false);
    assert.equal(drag('balls.cue.at.0'), true);
});
