// @ts-check
// Applies the chosen theme (`ui/theme.ts`) before the first paint, and hides the start screen of `index.html` if a project
// opens (`storage/last-project.ts`). Not a module, because the page must wait for it.
try {
  const theme = localStorage.getItem('inkpanel.theme');
  const project = sessionStorage.getItem('inkpanel.project') ?? localStorage.getItem('inkpanel.project');
  if (project) document.documentElement.dataset.opens = 'true';
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // Storage may be refused; the system then decides.
}
