//! Takes needless clamps out of a wasm module. The narrowing instructions saturate anyway. rustc's intrinsics
//! for them are a clamp and a truncation. LLVM compiles these to
//!
//! ```text
//! narrow(min(max(a, 0), 255), ...)            a clamp that the instruction after it repeats
//! shuffle(min(max(a, -32768), 32767), ...)    the same with two shuffles in place of the instruction
//! ```
//!
//! wasm-opt does neither. Both become `narrow(a, ...)`, only if the limits are not tighter than the limits of
//! the instruction. So results do not change. Everything else is copied unchanged, so a module never grows.

use std::ops::Range;

use anyhow::{Context, Result, ensure};
use wasm_encoder::{CodeSection, Module, RawSection};
use wasmparser::{
    FuncToValidate, FuncValidatorAllocations, FunctionBody, Operator, OperatorsReader, Parser, Payload, V128,
    ValidPayload, Validator, ValidatorResources,
};

/// `i16x8.narrow_i32x4_s`.
const NARROW_TO_I16: &[u8] = &[0xfd, 0x85, 0x01];

/// The lower half of each 32-bit lane of two vectors.
const LOWER_HALVES: [u8; 16] = [0, 1, 4, 5, 8, 9, 12, 13, 16, 17, 20, 21, 24, 25, 28, 29];

/// Returns the module without unnecessary clamps, and the number of removed instructions.
pub fn remove(module: &[u8]) -> Result<(Vec<u8>, usize)> {
    let mut validator = Validator::new();
    let mut out = Module::new();
    let mut code = CodeSection::new();
    let (mut left, mut removed) = (0, 0);
    for payload in Parser::new(0).parse_all(module) {
        let payload = payload?;
        let valid = validator.payload(&payload)?;
        match (payload, valid) {
            (Payload::CodeSectionStart { count, .. }, _) => left = count,
            (Payload::CodeSectionEntry(_), ValidPayload::Func(function, body)) => {
                let edits = edits(function, &body)?;
                removed += edits.iter().filter(|edit| edit.bytes.is_empty()).count();
                code.raw(&edited(module, body.range(), edits));
                left -= 1;
                if left == 0 {
                    out.section(&code);
                }
            }
            (payload, _) => {
                if let Some((id, range)) = payload.as_section() {
                    out.section(&RawSection { id, data: &module[range] });
                }
            }
        }
    }
    let out = out.finish();
    ensure!(out.len() <= module.len(), "the module grew from {} to {} bytes", module.len(), out.len());
    Validator::new().validate_all(&out).context("the module without needless clamps is not valid")?;
    Ok((out, removed))
}

/// A replacement of bytes in the module.
struct Edit {
    range: Range<usize>,
    bytes: &'static [u8],
}

fn edited(module: &[u8], body: Range<usize>, mut edits: Vec<Edit>) -> Vec<u8> {
    edits.sort_by_key(|edit| edit.range.start);
    let (mut out, mut done) = (Vec::with_capacity(body.len()), body.start);
    for edit in edits {
        out.extend_from_slice(&module[done..edit.range.start]);
        out.extend_from_slice(edit.bytes);
        done = edit.range.end;
    }
    out.extend_from_slice(&module[done..body.end]);
    out
}

/// One instruction of a function.
struct Step<'a> {
    operator: Operator<'a>,
    range: Range<usize>,
    /// The instruction that made the lowest of its operands.
    source: Option<usize>,
}

fn edits(function: FuncToValidate<ValidatorResources>, body: &FunctionBody<'_>) -> Result<Vec<Edit>> {
    let mut validator = function.into_validator(FuncValidatorAllocations::default());
    let mut reader = body.get_binary_reader();
    validator.read_locals(&mut reader)?;
    let mut reader = OperatorsReader::new(reader);
    let (mut steps, mut edits) = (Vec::new(), Vec::new());
    // Which instruction made each operand on the stack.
    let mut made: Vec<usize> = Vec::new();
    while !reader.eof() {
        let start = reader.original_position();
        let operator = reader.read()?;
        let (taken, given) =
            operator.operator_arity(&validator).context("an instruction of unknown arity")?;
        let lowest = made.len().checked_sub(taken as usize);
        validator.op(start, &operator)?;
        // A branch can leave any stack height. The validator has the value.
        let height = validator.operand_stack_height() as usize;
        let operands = lowest.map(|lowest| made.split_off(lowest)).unwrap_or_default();
        made.truncate(height.saturating_sub(given as usize));
        made.resize(height, steps.len());
        let range = start..reader.original_position();
        if let [first, second] = operands[..] {
            narrowing(&steps, &operator, range.clone(), [first, second], &mut edits);
        }
        steps.push(Step { operator, range, source: operands.first().copied() });
    }
    Ok(edits)
}

/// A possible replacement for an instruction that narrows two operands.
fn narrowing(
    steps: &[Step<'_>],
    operator: &Operator<'_>,
    range: Range<usize>,
    operands: [usize; 2],
    edits: &mut Vec<Edit>,
) {
    let limits = match operator {
        Operator::I8x16NarrowI16x8S => Limits { bits: 16, least: -128, most: 127 },
        Operator::I8x16NarrowI16x8U => Limits { bits: 16, least: 0, most: 255 },
        Operator::I16x8NarrowI32x4S => TO_I16,
        Operator::I16x8NarrowI32x4U => Limits { bits: 32, least: 0, most: 65535 },
        Operator::I8x16Shuffle { lanes } if *lanes == LOWER_HALVES => {
            if !operands.iter().all(|&operand| fits_i16(steps, operand)) {
                return;
            }
            edits.push(Edit { range, bytes: NARROW_TO_I16 });
            TO_I16
        }
        _ => return,
    };
    for operand in operands {
        let mut made_by = Some(operand);
        while let Some(bound) = made_by.and_then(|i| Bound::of(steps, i, limits.bits)) {
            if !bound.is_needless(limits) {
                break;
            }
            edits.push(Edit { range: bound.range, bytes: &[] });
            made_by = bound.source;
        }
    }
}

/// Saturation limits of an instruction, and its lane width.
#[derive(Clone, Copy)]
struct Limits {
    bits: u32,
    least: i32,
    most: i32,
}

const TO_I16: Limits = Limits { bits: 32, least: -32768, most: 32767 };

/// The minimum or maximum of a vector and a constant.
struct Bound {
    is_least: bool,
    /// Smallest and largest lane of the constant.
    lanes: (i32, i32),
    /// The constant and the instruction.
    range: Range<usize>,
    /// The instruction that made the vector.
    source: Option<usize>,
}

impl Bound {
    /// The clamp at instruction `i`, if it is one, on signed lanes of `bits` bits.
    fn of(steps: &[Step<'_>], i: usize, bits: u32) -> Option<Self> {
        let step = steps.get(i)?;
        let is_least = match (&step.operator, bits) {
            (Operator::I16x8MaxS, 16) | (Operator::I32x4MaxS, 32) => true,
            (Operator::I16x8MinS, 16) | (Operator::I32x4MinS, 32) => false,
            _ => return None,
        };
        let before = steps.get(i.checked_sub(1)?)?;
        let Operator::V128Const { value } = &before.operator else { return None };
        let lanes = lanes(*value, bits);
        let lanes = (lanes.clone().min()?, lanes.max()?);
        Some(Self { is_least, lanes, range: before.range.start..step.range.end, source: step.source })
    }

    fn is_needless(&self, limits: Limits) -> bool {
        if self.is_least { self.lanes.1 <= limits.least } else { self.lanes.0 >= limits.most }
    }
}

fn lanes(vector: V128, bits: u32) -> impl Iterator<Item = i32> + Clone {
    let bytes = *vector.bytes();
    (0..128 / bits as usize).map(move |lane| match bits {
        16 => i32::from(i16::from_le_bytes([bytes[2 * lane], bytes[2 * lane + 1]])),
        _ => i32::from_le_bytes(std::array::from_fn(|i| bytes[4 * lane + i])),
    })
}

/// Whether instruction `i` is the second of two bounds, one from below and one from above, that 16 bits hold.
fn fits_i16(steps: &[Step<'_>], i: usize) -> bool {
    let inside = |bound: &Bound| bound.lanes.0 >= TO_I16.least && bound.lanes.1 <= TO_I16.most;
    let Some(outer) = Bound::of(steps, i, 32).filter(inside) else { return false };
    let inner = outer.source.and_then(|source| Bound::of(steps, source, 32)).filter(inside);
    inner.is_some_and(|inner| inner.is_least != outer.is_least)
}

#[cfg(test)]
mod tests {
    use super::*;
    use wasm_encoder::{
        ExportKind, ExportSection, Function, FunctionSection, Instruction, TypeSection, ValType,
    };

    use Instruction::{
        I8x16NarrowI16x8S, I8x16NarrowI16x8U, I8x16Shuffle, I16x8MaxS, I16x8MinS, I16x8NarrowI32x4S,
        I16x8NarrowI32x4U, I32x4MaxS, I32x4MinS, LocalGet, LocalTee, V128Const,
    };

    /// A module with one function of two vectors that returns one.
    fn module(body: &[Instruction<'_>]) -> Vec<u8> {
        let mut types = TypeSection::new();
        types.ty().function([ValType::V128; 2], [ValType::V128]);
        let mut functions = FunctionSection::new();
        functions.function(0);
        let mut exports = ExportSection::new();
        exports.export("f", ExportKind::Func, 0);
        let mut function = Function::new([]);
        for instruction in body {
            function.instruction(instruction);
        }
        function.instruction(&Instruction::End);
        let mut code = CodeSection::new();
        code.function(&function);
        let mut module = Module::new();
        module.section(&types).section(&functions).section(&exports).section(&code);
        module.finish()
    }

    fn wide16(value: i16) -> Instruction<'static> {
        V128Const(i128::from_le_bytes(bytes(|i| value.to_le_bytes()[i % 2])))
    }

    fn wide32(value: i32) -> Instruction<'static> {
        V128Const(i128::from_le_bytes(bytes(|i| value.to_le_bytes()[i % 4])))
    }

    fn bytes(at: impl Fn(usize) -> u8) -> [u8; 16] {
        std::array::from_fn(at)
    }

    #[track_caller]
    fn assert_becomes(before: &[Instruction<'_>], after: &[Instruction<'_>], removed: usize) {
        assert_eq!(remove(&module(before)).unwrap(), (module(after), removed));
    }

    /// Both vectors clamped by 16-bit lanes, low bound first or high bound first, then narrowed.
    fn clamped(
        low: i16,
        high: i16,
        low_first: bool,
        narrow: Instruction<'static>,
    ) -> Vec<Instruction<'static>> {
        let mut body = Vec::new();
        for i in 0..2 {
            body.push(LocalGet(i));
            let bounds = [[wide16(low), I16x8MaxS], [wide16(high), I16x8MinS]];
            body.extend(bounds[usize::from(!low_first)].clone());
            body.extend(bounds[usize::from(low_first)].clone());
        }
        body.push(narrow);
        body
    }

    #[test]
    fn a_clamp_to_the_narrow_s_own_bounds_or_wider_goes_in_either_order() {
        for (low, high, narrow) in
            [(0, 255, I8x16NarrowI16x8U), (-3, 300, I8x16NarrowI16x8U), (-128, 127, I8x16NarrowI16x8S)]
        {
            for low_first in [true, false] {
                let before = clamped(low, high, low_first, narrow.clone());
                assert_becomes(&before, &[LocalGet(0), LocalGet(1), narrow.clone()], 4);
            }
        }
    }

    #[test]
    fn tighter_bounds_stay_and_only_they() {
        let before = clamped(0, 254, true, I8x16NarrowI16x8U);
        assert_becomes(&before, &before, 0);
        // The lower clamp is removed if it directly precedes the narrowing.
        let before = clamped(0, 254, false, I8x16NarrowI16x8U);
        let kept = |i| [LocalGet(i), wide16(254), I16x8MinS];
        let after = [kept(0), kept(1)].concat();
        assert_becomes(&before, &[after, vec![I8x16NarrowI16x8U]].concat(), 2);
        let before = clamped(-128, 127, true, I8x16NarrowI16x8U);
        assert_becomes(&before, &before, 0);
    }

    #[test]
    fn one_tight_lane_keeps_the_bound() {
        let lanes =
            V128Const(i128::from_le_bytes(bytes(|i| if i == 6 { 254 } else { u8::from(i % 2 == 0) * 255 })));
        let before = [LocalGet(0), lanes, I16x8MinS, LocalGet(1), I8x16NarrowI16x8U];
        assert_becomes(&before, &before, 0);
    }

    #[test]
    fn lanes_of_another_width_and_values_used_elsewhere_stay() {
        let before = [LocalGet(0), wide32(65535), I32x4MinS, LocalGet(1), I8x16NarrowI16x8S];
        assert_becomes(&before, &before, 0);
        let before = [LocalGet(0), wide16(255), I16x8MinS, LocalTee(0), LocalGet(0), I8x16NarrowI16x8U];
        assert_becomes(&before, &before, 0);
        let after = [LocalGet(0), LocalGet(1), I16x8NarrowI32x4U];
        assert_becomes(&[LocalGet(0), wide32(65535), I32x4MinS, LocalGet(1), I16x8NarrowI32x4U], &after, 1);
    }

    #[test]
    fn clamped_halves_shuffled_together_are_a_narrow() {
        let body = |low: i32, last: Instruction<'static>| {
            let operand = |i| [LocalGet(i), wide32(low), I32x4MaxS, wide32(32767), I32x4MinS];
            [operand(0).to_vec(), operand(1).to_vec(), vec![last]].concat()
        };
        let narrowed = [LocalGet(0), LocalGet(1), I16x8NarrowI32x4S];
        assert_becomes(&body(-32768, I8x16Shuffle(LOWER_HALVES)), &narrowed, 4);
        // The upper limit is tighter here. The instruction is correct, and the lower limit must stay.
        let kept = |i| [LocalGet(i), wide32(0), I32x4MaxS].to_vec();
        let after = [kept(0), kept(1), vec![I16x8NarrowI32x4S]].concat();
        assert_becomes(&body(0, I8x16Shuffle(LOWER_HALVES)), &after, 2);
        // Values that 16 bits do not hold are cut by the shuffle, and so are those without a bound.
        let before = body(-32769, I8x16Shuffle(LOWER_HALVES));
        assert_becomes(&before, &before, 0);
        let before = [LocalGet(0), LocalGet(1), I8x16Shuffle(LOWER_HALVES)];
        assert_becomes(&before, &before, 0);
        let before = body(-32768, I8x16Shuffle(bytes(|i| i as u8)));
        assert_becomes(&before, &before, 0);
    }
}
