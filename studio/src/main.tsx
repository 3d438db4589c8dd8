import { render } from 'preact';
import { connect } from './connection/socket';
import { cancelGesture } from './edit/edit';
import { Shell } from './shell/Shell';
import { watchTheme } from './shell/theme';
import { listenToKeys, onCommand } from './state/keys';
import { exposeStudio } from './state/studio';
import { travel } from './text/buffers';
import { saveAll, watchFiles } from './text/saving';
import { watchAnswers } from './text/sending';
import './style/main.css';

const app = document.getElementById('app');
if (app) {
    exposeStudio();
    watchTheme();
    watchFiles();
    watchAnswers();
    listenToKeys();
    onCommand('save', saveAll);
    onCommand('undo', () => { travel(true); });
    onCommand('redo', () => { travel(false); });
    onCommand('cancel', () => { cancelGesture(); });
    render(<Shell />, app);
    connect();
}
