import { render } from 'preact';
import { connect } from './connection/socket';
import { Shell } from './shell/Shell';
import { exposeStudio } from './state/studio';
import './style/main.css';

const app = document.getElementById('app');
if (app) {
    exposeStudio();
    render(<Shell />, app);
    connect();
}
