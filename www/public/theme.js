// @ts-check
// Applies the chosen theme (`ui/theme.ts`) before the first paint. Not a module, because the page must wait for it.
try {
  const theme = localStorage.getItem('inkpanel.theme');
  if (theme === 'light' || theme === 'dark') document.documentElement.dataset.theme = theme;
} catch {
  // Storage may be refused; the system then decides.
}
