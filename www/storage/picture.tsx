import { useEffect, useState } from 'preact/hooks';

/** The thumbnail of a project. */
export function Picture({ blob }: { blob: Blob }) {
  const [address, setAddress] = useState('');
  useEffect(() => {
    const made = URL.createObjectURL(blob);
    setAddress(made);
    return () => URL.revokeObjectURL(made);
  }, [blob]);
  return address === '' ? null : <img src={address} alt="" />;
}
