// @ts-check
// The theme that was chosen (`ui/theme.ts`), before anything is painted: it is no module, so the page waits for it.
try {
  const theme = localStorage.getItem('inkpanel.theme');
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // Storage may be refused; the system then decides.
}
