// @ts-check
/** Makes the saved projects and pages of this folder; see README.md. */

import config from '../../../www/playwright.config.js';

export default { ...config, testDir: '.', outputDir: '../../web/results', testMatch: 'make.mjs', webServer: { ...config.webServer, cwd: '../../../www' } };
