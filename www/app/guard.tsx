/** Error boundary: if the views cannot draw the store, it shows a replacement until another project is open. */

import { Component } from 'preact';
import { useApp } from '../ui/context.ts';
import type { ComponentChildren } from 'preact';

export function Guard({ children, instead }: { children: ComponentChildren; instead: ComponentChildren }) {
  const { ui, keeping } = useApp();
  const onFailed = (error: unknown) => {
    ui.failed.value = error;
    keeping.failedToShow(error);
  };
  return (
    <Catcher failed={ui.failed.value !== null} onFailed={onFailed} instead={instead}>
      {children}
    </Catcher>
  );
}

type Caught = {
  failed: boolean;
  onFailed: (error: unknown) => void;
  children: ComponentChildren;
  instead: ComponentChildren;
};

class Catcher extends Component<Caught> {
  componentDidCatch(error: unknown) {
    const { failed, onFailed } = this.props;
    // The replacement itself must not fail.
    if (failed) throw error;
    onFailed(error);
    this.setState({});
  }

  render() {
    const { failed, children, instead } = this.props;
    return failed ? instead : children;
  }
}
