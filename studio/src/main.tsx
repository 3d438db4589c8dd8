import { render } from 'preact';
import { takeKeys } from './connection/key';
import { connect, watchKeys } from './connection/socket';
import { Dialogs } from './dialogs/Dialogs';
import { watchQuestions } from './dialogs/edit_question';
import { watchRecovery } from './dialogs/recovery_dialog';
import * as edit from './edit/edit';
import { tracks } from './motion/clock';
import { watchDocuments } from './documents/documents_state';
import { film, watchFilms } from './films/film_state';
import { loadSchema } from './schema/schema';
import { Shell } from './shell/Shell';
import { watchTheme } from './shell/theme';
import { watchAddress } from './state/address';
import { listenToKeys, onCommand } from './state/keys';
import { filmThumbnails } from './state/film_thumbnails';
import { isStarting, panel, selection } from './state/state';
import { followKind } from './sequence/parts';
import { exposeStudio } from './state/studio';
import { openShot, watchExisting } from './start/file_actions';
import { watchDrops } from './start/import_scene';
import { chooseShot } from './start/OpenShot';
import { saveAs } from './start/SaveAs';
import { StartScreen } from './start/StartScreen';
import { activeFile, bufferOf, textOf, travel, typeStep } from './text/buffers';
import { loadConfigFiles } from './text/complete/config_files';
import { labelsAt } from './text/complete/source';
import { watchLeaving } from './text/discard';
import { focusProblems } from './text/ProblemList';
import { saveAll, watchFiles } from './text/saving';
import { watchAnswers } from './text/sending';
import { keepTexts } from './text/session_store';
import { undoable } from './text/steps';
import { undoStep } from './text/undo_commands';
import './style/main.css';

/// The text of the shown tab, for tests.
function activeText(): string {
    const buffer = bufferOf(activeFile.value);
    return buffer ? textOf(buffer) : '';
}

function App() {
    return isStarting.value ? <StartScreen /> : <Shell />;
}

const app = document.getElementById('app');
if (app) {
    takeKeys();
    exposeStudio();
    window.studio['edit'] = {
        ...edit, travel, text: activeText, steps: () => undoable.value.length,
        type: (from: number, to: number, insert: string) =>
            typeStep([{ file: activeFile.value, changes: { from, to, insert } }]),
    };
    window.studio['labelsAt'] = labelsAt;
    window.studio['films'] = { film, thumbnails: filmThumbnails };
    window.studio['open'] = openShot;
    window.studio['tracks'] = tracks;
    watchTheme();
    watchFiles();
    watchAnswers();
    watchLeaving();
    keepTexts();
    watchRecovery();
    watchQuestions();
    listenToKeys();
    watchAddress();
    followKind();
    onCommand('save', saveAll);
    onCommand('problems', focusProblems);
    watchExisting();
    watchFilms();
    watchDocuments();
    watchDrops();
    onCommand('open', () => { void chooseShot(); });
    onCommand('saveAs', saveAs);
    onCommand('keys', () => { panel.value = 'keys'; });
    onCommand('undo', () => { undoStep(true); });
    onCommand('redo', () => { undoStep(false); });
    onCommand('cancel', () => {
        if (!edit.cancelGesture()) {
            selection.value = null;
        }
    });
    render(<><App /><Dialogs /></>, app);
    void loadSchema();
    void loadConfigFiles();
    connect();
    watchKeys();
}
